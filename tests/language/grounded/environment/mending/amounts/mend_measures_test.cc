#include "latticeworld/language/grounded/environment/mending/amounts/mend_measures.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/grounded/environment/mending/mend_ways.h"

namespace latticeworld {
namespace {

std::string Mended(std::string_view text) {
  std::vector<Token> tokens = Tokenize(text);
  MendMeasures(&tokens);
  return JoinWords(tokens, 0, tokens.size());
}

TEST(MendMeasuresTest, FractionsBesideADensityAreNumbers) {
  EXPECT_EQ(Mended("oaks at half density"), "oaks at density 0.5");
  EXPECT_EQ(Mended("flowers at a density of one third"), "flowers at a density 0.33");
  EXPECT_EQ(Mended("half of the sheep"), "half of the sheep");
}

TEST(MendMeasuresTest, AFullStopWithinANameEndsNoSentence) {
  EXPECT_EQ(Mended("forest.density"), "forest density");
  EXPECT_EQ(Mended("forest. density"), "forest . density");
}

TEST(MendMeasuresTest, TheAnswerToHowManyIsATotal) {
  EXPECT_EQ(Mended("How many are there? Ten!"), "ten agents in total !");
  EXPECT_EQ(Mended("How many are there? Ten goblins."), "how many are there ? ten goblins .");
}

TEST(MendMeasuresTest, LevelsAreSaidAfterTheirMeasure) {
  EXPECT_EQ(Mended("low by one metre"), "one metre lower");
  EXPECT_EQ(Mended("low by the houses"), "low by the houses");
}

TEST(MendMeasuresTest, EachKindIsNamed) {
  EXPECT_EQ(Mended("ten of each kind of robot"),
            "ten wheeled robots , ten humanoid robots , ten robotic dogs , ten drones");
}

TEST(MendMeasuresTest, TurnsOfPhraseAreSaidPlainly) {
  EXPECT_EQ(Mended("four up north"), "four in the north");
  EXPECT_EQ(Mended("they chase one another"), "they chase each other");
  EXPECT_EQ(Mended("four up top, five down bottom"), "four at the top , five at the bottom");
  EXPECT_EQ(Mended("Christmas Eve"), "christmas");
  EXPECT_EQ(Mended("a quiet eve"), "a quiet eve");
  EXPECT_EQ(Mended("one standing guard"), "one guarding");
  EXPECT_EQ(Mended("sky: grey"), "sky grey");
  EXPECT_EQ(Mended("two sheep and, hmm, three horses"), "two sheep and , three horses");
  EXPECT_EQ(Mended("two sheep, hmm, three"), "two sheep , hmm , three");
}

TEST(MendMeasuresTest, HalvesAreAddedToTheirNumber) {
  EXPECT_EQ(Mended("a metre and a half below normal"), "1.5 metre below normal");
  EXPECT_EQ(Mended("two and a half metres higher"), "2.5 metres higher");
  EXPECT_EQ(Mended("a good metre higher"), "a metre higher");
  EXPECT_EQ(Mended("a sheep and a half-dead goat"), "a sheep and a half dead goat");
}

TEST(MendMeasuresTest, TheMiddleOfATimeIsNoPlace) {
  EXPECT_EQ(Mended("in the middle of the night"), "in night");
  EXPECT_EQ(Mended("in the middle of the day"), "in noon");
  EXPECT_EQ(Mended("in the middle of a storm"), "in a storm");
  EXPECT_EQ(Mended("in the middle of the lake"), "in the middle of the lake");
  EXPECT_EQ(Mended("fog is rolling in"), "fog is coming in");
}

TEST(MendWaysTest, PlacesAreToldByWays) {
  const auto mended = [](std::string_view text) {
    std::vector<Token> tokens = Tokenize(text);
    MendWays(&tokens);
    return JoinWords(tokens, 0, tokens.size());
  };
  EXPECT_EQ(mended("a drone above where the road crosses the river"), "a drone above the bridge");
  EXPECT_EQ(mended("knights where the road enters the village"),
            "knights on the road by the village");
  EXPECT_EQ(mended("where it comes into the map"), "where it comes into the map");
  EXPECT_EQ(mended("two halfway along the road"), "two in the middle of the road");
  EXPECT_EQ(mended("two halfway"), "two in the middle");
}

}  // namespace
}  // namespace latticeworld
