#include "latticeworld/language/local/tokens/token_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace latticeworld {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kLowest = std::numeric_limits<float>::lowest();
constexpr int kDraws = 200;

const std::vector<TokenId> kAllowed = {1, 2, 3, 4};

// How often each token is drawn, at that temperature and at 0; the last: none was.
std::vector<int> Draws(const std::vector<float>& logits, double temperature) {
  RandomStream random(7, "draws");
  std::vector<int> counts(logits.size() + 1);
  for (int i = 0; i < kDraws; ++i)
    ++counts[ChooseToken(logits, kAllowed, temperature, &random).value_or(logits.size())];
  return counts;
}

TEST(TokenChoiceTest, DrawsByTheSoftmaxOfTheAllowed) {
  const std::vector<int> counts = Draws({100.0f, 1.0f, 1.0f, -9.0f, 2.0f, 100.0f}, 1.0);
  EXPECT_EQ(counts[0] + counts[5] + counts[6], 0);
  EXPECT_NEAR(counts[4], kDraws * 0.576, 30);
  EXPECT_NEAR(counts[1], kDraws * 0.212, 30);
  EXPECT_LT(counts[3], 3);
}

TEST(TokenChoiceTest, ChoosesNothingWhereNothingAllowedHasANumber) {
  for (const double temperature : {0.0, 1e-300, 1.0}) {
    EXPECT_EQ(Draws({1.0f, kNan, kNan, kNan, kNan, 1.0f}, temperature)[6], kDraws);
    EXPECT_EQ(Draws({1.0f, -kInfinity, kNan, -kInfinity, kNan, 1.0f}, temperature)[6], kDraws);
  }
}

TEST(TokenChoiceTest, NeverChoosesWhatHasNoNumber) {
  for (const double temperature : {0.0, 1.0, 1e5}) {
    EXPECT_EQ(Draws({0.0f, kNan, -kInfinity, kLowest, kNan, 0.0f}, temperature)[3], kDraws);
    const std::vector<int> counts = Draws({0.0f, kNan, 1.0f, -kInfinity, 1.0f, 0.0f}, temperature);
    EXPECT_EQ(counts[2] + counts[4], kDraws);
  }
}

TEST(TokenChoiceTest, ChoosesTheFirstThatIsInfinite) {
  for (const double temperature : {0.0, 1.0})
    EXPECT_EQ(Draws({0.0f, 3.0f, kNan, kInfinity, kInfinity, 0.0f}, temperature)[3], kDraws);
}

TEST(LogProbabilityTest, IsThatOfTheSoftmaxOverWhatIsAllowed) {
  const std::vector<float> logits = {1.0f, 3.0f, 2.0f, 900.0f};
  const double both = std::exp(1.0) + std::exp(2.0);
  EXPECT_NEAR(LogProbability(logits, {0, 2}, 0), 1.0 - std::log(both), 1e-9);
  EXPECT_NEAR(LogProbability(logits, {0, 2}, 2), 2.0 - std::log(both), 1e-9);
  EXPECT_EQ(LogProbability(logits, {3}, 3), 0.0);
  EXPECT_NEAR(LogProbability(logits, {0, 3}, 3), 0.0, 1e-9);
}

TEST(LogProbabilityTest, TokensWithoutANumberHaveNoShareInIt) {
  const float nothing = std::numeric_limits<float>::quiet_NaN();
  const float never = -std::numeric_limits<float>::infinity();
  EXPECT_EQ(LogProbability({1.0f, nothing, never}, {0, 1, 2}, 0), 0.0);
}

}  // namespace
}  // namespace latticeworld
