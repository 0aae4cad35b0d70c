#include "latticeworld/dataset/captions/relief_words.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <string>

namespace latticeworld {
namespace {

Relief ReliefOf(const std::function<double(double east, double south)>& height_m) {
  Grid<float> heights(65, 65, 0.0f);
  for (int row = 0; row < 65; ++row) {
    for (int col = 0; col < 65; ++col) {
      heights(row, col) = static_cast<float>(height_m(col / 64.0, row / 64.0));
    }
  }
  return MakeRelief(std::move(heights));
}

TEST(ReliefWordsTest, APlaneRisesTowardItsHighSide) {
  const ReliefFacts facts =
      FactsOf(ReliefOf([](double east, double south) { return 40.0 * east - 40.0 * south; }));
  EXPECT_EQ(facts.rise_east, 1);
  EXPECT_EQ(facts.rise_south, -1);
  EXPECT_NEAR(facts.rise_share, 1.0, 0.01);
  EXPECT_EQ(facts.highest, Region::kUpperRight);
  EXPECT_EQ(facts.lowest, Region::kLowerLeft);
  for (const auto& voice : EnumNames(Voice{})) {
    RandomStream random(1, "test");
    const std::string text = WordRelief(facts, voice.value, false, &random);
    const std::size_t high = text.find("north-east"), low = text.find("south-west");
    EXPECT_TRUE(high != std::string::npos || low != std::string::npos) << text;
    EXPECT_EQ(text.find("upper"), std::string::npos) << text;
  }
}

TEST(ReliefWordsTest, EveryHeadingIsTold) {
  const double pi = std::acos(-1.0);
  std::set<std::pair<int, int>> headings;
  for (int eighth = 0; eighth < 8; ++eighth) {
    const double east = std::cos(eighth * pi / 4), south = std::sin(eighth * pi / 4);
    const ReliefFacts facts =
        FactsOf(ReliefOf([&](double u, double v) { return 30.0 * (u * east + v * south); }));
    EXPECT_EQ(facts.rise_east, std::lround(east)) << eighth;
    EXPECT_EQ(facts.rise_south, std::lround(south)) << eighth;
    EXPECT_NEAR(facts.rise_m, 30.0, 2.0);
    headings.insert({facts.rise_east, facts.rise_south});
  }
  EXPECT_EQ(headings.size(), 8u);
}

TEST(ReliefWordsTest, FlatLandAHillAndABasinAreToldApart) {
  const auto word = [](const Relief& relief) {
    RandomStream random(2, "test");
    return WordRelief(FactsOf(relief), Voice::kTerse, false, &random);
  };
  const auto from_middle = [](double east, double south) {
    return std::hypot(east - 0.5, south - 0.5);
  };
  EXPECT_NE(word(ReliefOf([](double, double) { return 7.0; })).find("flat"), std::string::npos);
  const std::string hill =
      word(ReliefOf([&](double u, double v) { return -80.0 * from_middle(u, v); }));
  EXPECT_NE(hill.find("igh middle"), std::string::npos) << hill;
  const std::string basin =
      word(ReliefOf([&](double u, double v) { return 80.0 * from_middle(u, v); }));
  EXPECT_NE(basin.find("ow middle"), std::string::npos) << basin;
  const std::string rolling = word(
      ReliefOf([](double u, double v) { return 5.0 * std::sin(38.0 * u) * std::sin(38.0 * v); }));
  EXPECT_NE(rolling.find("olling"), std::string::npos) << rolling;
}

TEST(ReliefWordsTest, PictureWordsAreAnotherWayToSayThePlace) {
  const ReliefFacts facts = FactsOf(ReliefOf([](double, double south) { return 50.0 * south; }));
  std::set<std::string> texts;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    RandomStream random(seed, "test");
    const std::string text = WordRelief(facts, Voice::kSpoken, true, &random);
    EXPECT_EQ(text.find("south"), std::string::npos) << text;
    EXPECT_NE(text.find("bottom"), std::string::npos) << text;
    EXPECT_EQ(text.find_first_of("{}"), std::string::npos) << text;
    texts.insert(text);
  }
  EXPECT_GE(texts.size(), 3u) << "varied";
}

}  // namespace
}  // namespace latticeworld
