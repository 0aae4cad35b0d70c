#include "tools/progress_display.h"

#include <gtest/gtest.h>

namespace latticeworld::tools {
namespace {

const std::vector<StageShare> kShares = {{"terrain", 0.6}, {"scene", 0.3}, {"save", 0.1}};

TEST(ProgressDisplayTest, WhatIsLeftIsTheRestOfTheStageAndWhatFollows) {
  // Half of terrain in 6 s: 6 s more, then scene half as long as terrain's 12 s, then save's 2 s.
  EXPECT_DOUBLE_EQ(EstimateLeft(kShares, "terrain", 0.5, 6.0), 6.0 + 6.0 + 2.0);
  EXPECT_DOUBLE_EQ(EstimateLeft(kShares, "scene", 0.25, 1.0), 3.0 + 4.0 / 3.0);
  EXPECT_DOUBLE_EQ(EstimateLeft(kShares, "save", 1.0, 2.0), 0.0);
}

TEST(ProgressDisplayTest, AStageThatIsNotListedStandsForItself) {
  EXPECT_DOUBLE_EQ(EstimateLeft(kShares, "layout", 0.2, 4.0), 16.0);
  EXPECT_DOUBLE_EQ(EstimateLeft({}, "picture", 0.75, 3.0), 1.0);
}

TEST(ProgressDisplayTest, TooLittleTellsNothing) {
  EXPECT_EQ(EstimateLeft(kShares, "terrain", 0.0, 100.0), -1.0);
  EXPECT_EQ(EstimateLeft(kShares, "terrain", 0.9, 0.1), -1.0);
}

TEST(ProgressDisplayTest, ALineHasBarStagePercentageAndTime) {
  EXPECT_EQ(ProgressLine("terrain", 0.3, 12.4), "[######--------------] terrain 30 %, 0:12 left");
  EXPECT_EQ(ProgressLine("layout", 0.0, -1.0), "[--------------------] layout 0 %");
  EXPECT_EQ(ProgressLine("save", 1.0, 3725.0), "[####################] save 100 %, 1:02:05 left");
  EXPECT_EQ(ProgressLine("save", 7.0, 0.0), "[####################] save 100 %, 0:00 left");
}

}  // namespace
}  // namespace latticeworld::tools
