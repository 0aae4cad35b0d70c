#include "latticeworld/common/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

namespace latticeworld {
namespace {

TEST(RandomStreamTest, SameSeedAndNameGiveTheSameDraws) {
  RandomStream first(7, "trees"), second(7, "trees");
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(first.NextBits(), second.NextBits());
}

TEST(RandomStreamTest, SeedAndNameBothMatter) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    for (const char* name : {"", "trees", "stones"}) seeds.insert(StreamSeed(seed, name));
  }
  EXPECT_EQ(seeds.size(), 300u);
}

TEST(RandomStreamTest, UniformHasTheMomentsOfAUniformDistribution) {
  RandomStream random(1, "moments");
  double sum = 0.0, sum_of_squares = 0.0;
  constexpr int kDraws = 100000;
  for (int i = 0; i < kDraws; ++i) {
    const double value = random.Uniform();
    ASSERT_GE(value, 0.0);
    ASSERT_LT(value, 1.0);
    sum += value;
    sum_of_squares += value * value;
  }
  EXPECT_NEAR(sum / kDraws, 0.5, 0.005);
  EXPECT_NEAR(sum_of_squares / kDraws, 1.0 / 3.0, 0.005);
}

TEST(RandomStreamTest, UniformIntReachesBothEndsAndNothingElse) {
  RandomStream random(2, "dice");
  std::set<int> seen;
  for (int i = 0; i < 1000; ++i) seen.insert(random.UniformInt(-1, 4));
  EXPECT_EQ(seen, (std::set<int>{-1, 0, 1, 2, 3, 4}));
}

TEST(RandomStreamTest, NormalHasTheMomentsAskedFor) {
  RandomStream random(3, "normal");
  constexpr int kDraws = 100000;
  double sum = 0.0, sum_of_squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double value = random.Normal(5.0, 2.0);
    sum += value;
    sum_of_squares += (value - 5.0) * (value - 5.0);
  }
  EXPECT_NEAR(sum / kDraws, 5.0, 0.03);
  EXPECT_NEAR(std::sqrt(sum_of_squares / kDraws), 2.0, 0.03);
}

TEST(RandomStreamTest, WeightedNeverDrawsAZeroWeight) {
  RandomStream random(4, "weights");
  int counts[4] = {};
  for (int i = 0; i < 40000; ++i) ++counts[random.Weighted({0.0, 1.0, 3.0, 0.0})];
  EXPECT_EQ(counts[0], 0);
  EXPECT_EQ(counts[3], 0);
  EXPECT_NEAR(counts[2] / 40000.0, 0.75, 0.01);
}

TEST(RandomStreamTest, ShuffleKeepsTheElements) {
  RandomStream random(5, "shuffle");
  std::vector<int> values(100);
  std::iota(values.begin(), values.end(), 0);
  const std::vector<int> before = values;
  random.Shuffle(&values);
  EXPECT_NE(values, before);
  std::sort(values.begin(), values.end());
  EXPECT_EQ(values, before);
}

TEST(HashToUnitTest, NeighboursAreUncorrelated) {
  double sum = 0.0;
  constexpr int kSide = 200;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      sum += (HashToUnit(9, x, y) - 0.5) * (HashToUnit(9, x + 1, y) - 0.5);
    }
  }
  EXPECT_NEAR(sum / (kSide * kSide), 0.0, 0.002);
}

}  // namespace
}  // namespace latticeworld
