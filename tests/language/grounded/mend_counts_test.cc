#include "latticeworld/language/grounded/environment/mend_counts.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace latticeworld {
namespace {

std::string Mended(std::string_view text) {
  std::vector<Token> tokens = Tokenize(text);
  MendCounts(GetEnvironmentWords(), &tokens);
  return JoinWords(tokens, 0, tokens.size());
}

TEST(MendCountsTest, TheNumberThatIsMeantStandsAlone) {
  EXPECT_EQ(Mended("three no four drones"), "four drones");
  EXPECT_EQ(Mended("ten, I mean twelve, sheep"), "twelve sheep");
  EXPECT_EQ(Mended("five, no wait, six goblins"), "six goblins");
  EXPECT_EQ(Mended("no four drones"), "no four drones");
  EXPECT_EQ(Mended("two goblins, no wolves"), "two goblins , no wolves");
}

TEST(MendCountsTest, PartsBehindAColonAreOfTheWhole) {
  EXPECT_EQ(Mended("four rovers: two stand still, two patrol"),
            "four rovers : two of them stand still , two of them patrol");
  EXPECT_EQ(Mended("six animals: two sheep, four horses"), "six animals : two sheep , four horses");
  EXPECT_EQ(Mended("four rovers: two patrol, one sleeps"), "four rovers : two patrol , one sleeps")
      << "one is missing";
}

TEST(MendCountsTest, WhatUsedToBeIsNot) {
  EXPECT_EQ(Mended("there used to be goblins"), "there no goblins");
  EXPECT_EQ(Mended("there used to be ten horses; now there are only three"),
            "there used to be ten horses ; now there are only three");
}

}  // namespace
}  // namespace latticeworld
