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

TEST(MendCountsTest, WhatIsTakenBackBehindTheNounCounts) {
  EXPECT_EQ(Mended("four white horses, no, five of them"), "five white horses");
  EXPECT_EQ(Mended("four horses, five of them white"), "four horses , five of them white");
}

TEST(MendCountsTest, RoundNumbersAreAbout) {
  EXPECT_EQ(Mended("twenty or so sheep"), "about twenty sheep");
  EXPECT_EQ(Mended("twenty-odd sheep"), "about twenty sheep");
  EXPECT_EQ(Mended("a couple of dozen sheep"), "two dozen sheep");
  EXPECT_EQ(Mended("a couple of sheep"), "a couple of sheep");
  EXPECT_EQ(Mended("two or three sheep"), "two or three sheep");
}

TEST(MendCountsTest, KindsOfRobotsAreRobots) {
  EXPECT_EQ(Mended("robots: 3 wheeled, 2 aerial"), "robots : 3 wheeled robots , 2 aerial robots");
  EXPECT_EQ(Mended("robots: 3 wheeled carts"), "robots : 3 wheeled carts");
  EXPECT_EQ(Mended("3 wheeled, 2 aerial"), "3 wheeled , 2 aerial");
}

}  // namespace
}  // namespace latticeworld
