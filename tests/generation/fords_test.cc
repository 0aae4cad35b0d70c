#include "latticeworld/generation/fords.h"

#include <gtest/gtest.h>

namespace latticeworld {
namespace {

TEST(FordsTest, TheWordAsksForThemAndADenialDoesNot) {
  EXPECT_TRUE(AsksForFords("A road fords the river."));
  EXPECT_TRUE(AsksForFords("A river with a ford, and a road over it."));
  EXPECT_TRUE(AsksForFords("The river is FORDED by a road"));
  EXPECT_FALSE(AsksForFords("A road crosses the river."));
  EXPECT_FALSE(AsksForFords("A road leads over the river without a ford."));
  EXPECT_FALSE(AsksForFords("There are no fords over the river."));
  EXPECT_FALSE(AsksForFords("A road through Oxford and a ride in the Fordham woods."));
  EXPECT_FALSE(AsksForFords(""));
}

}  // namespace
}  // namespace latticeworld
