#include "latticeworld/language/reading/coverage.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "latticeworld/language/reading/claim_coverage.h"

namespace latticeworld {
namespace {

using Strings = std::vector<std::string>;

TextCoverage Layout(const std::string& text, const Strings& sentences) {
  return CoverageOf(text, sentences, SentenceKind::kLayout, Vocabulary::kSuburb);
}

TextCoverage Environment(const std::string& text, const Strings& sentences) {
  return CoverageOf(text, sentences, SentenceKind::kEnvironment, Vocabulary::kSuburb);
}

TEST(CoverageTest, OtherWordsForTheSameThingAreCarried) {
  const TextCoverage coverage =
      Layout("two little tarns on the left", {"2 small ponds in the west"});
  EXPECT_EQ(coverage.words, 3);  // two, little tarns, left
  EXPECT_EQ(coverage.carried, 3);
  EXPECT_TRUE(coverage.lost.empty());
  const TextCoverage orcs = Environment("On a misty morning three orcs rove about",
                                        {"Weather: fog", "Time: morning", "3 goblins patrolling"});
  EXPECT_EQ(orcs.carried, orcs.words);
}

// Each of the things that a text can ask for counts by itself.
TEST(CoverageTest, KnownNounsNumbersAndPlacesAreLost) {
  const std::string text = "three ponds in the north and a village";
  EXPECT_TRUE(Layout(text, {"3 ponds in the north", "A village"}).lost.empty());
  EXPECT_EQ(Layout(text, {"3 ponds in the north"}).lost, Strings{"village"});
  EXPECT_EQ(Layout(text, {"Ponds in the north", "A village"}).lost, Strings{"three"});
  EXPECT_EQ(Layout(text, {"3 ponds", "A village"}).lost, Strings{"north"});
  EXPECT_EQ(Environment("five sheep and a goblin", {"5 sheep"}).lost, Strings{"goblin"});
}

TEST(CoverageTest, WordsThatNobodyKnowsCountButAreNotTold) {
  const TextCoverage coverage = Layout("a lake with a melancholy zorblax", {"A lake"});
  EXPECT_EQ(coverage.words, 3);
  EXPECT_EQ(coverage.carried, 1);
  EXPECT_TRUE(coverage.lost.empty());
}

TEST(CoverageTest, InTheMiddleOfSomethingIsWithinIt) {
  const std::string text = "a hamlet in the middle of a forest";
  Claim within;
  within.kind = ClaimKind::kWithin;
  within.subject = 'B';
  within.object = 'F';
  within.words = text;
  EXPECT_TRUE(CoverageOf(text, {}, std::vector<Claim>{within}, Vocabulary::kSuburb).lost.empty());
  within.words = "a hamlet";
  EXPECT_EQ(CoverageOf(text, {}, std::vector<Claim>{within}, Vocabulary::kSuburb).lost,
            Strings{"middle"});
}

TEST(CoverageTest, NothingOfNothing) {
  EXPECT_EQ(Layout("", {}).words, 0);
  EXPECT_EQ(Layout("what the of and", {}).words, 0);
}

TEST(CoverageTest, PartsOfSharesAreNoNumbersOfThings) {
  const TextCoverage coverage = CoverageOf("two thirds woods", {"Forest covers 67 % of the map"},
                                           SentenceKind::kLayout, Vocabulary::kSuburb);
  EXPECT_TRUE(coverage.lost.empty());
}

TEST(CoverageTest, WhatClaimsAskForIsCarriedThoughNoSentenceSaysIt) {
  Claim lakes;
  lakes.kind = ClaimKind::kCount;
  lakes.subject = 'W';
  lakes.zone = *FindZone("northern half");
  lakes.least = 3.0;
  lakes.most = 5.0;
  const std::vector<Claim> claims = {lakes};
  const auto lost = [&claims](const std::string& text) {
    return CoverageOf(text, Strings(), claims, Vocabulary::kSuburb).lost;
  };
  EXPECT_EQ(lost("four lakes in the north"), Strings());
  EXPECT_EQ(lost("six lakes in the south, and a village"), (Strings{"six", "south", "village"}));
  EnvironmentClaim sheep;
  sheep.kind = EnvironmentClaimKind::kAgents;
  sheep.categories = {AgentCategory::kSheep};
  sheep.least_quantity = sheep.most_quantity = 5;
  sheep.positions = {Region::kUpperLeft};
  EnvironmentClaim more = sheep;
  more.least_quantity = more.most_quantity = 2;
  EXPECT_EQ(CoverageOf("seven sheep, of them two", Strings(),
                       std::vector<EnvironmentClaim>{sheep, more}, Vocabulary::kSuburb)
                .lost,
            Strings());
  EXPECT_EQ(CoverageOf("five sheep in the north-west and a goblin in the east", Strings(),
                       std::vector<EnvironmentClaim>{sheep}, Vocabulary::kSuburb)
                .lost,
            (Strings{"goblin", "east"}));
}

TEST(CoverageTest, WhatIsCarriedByNowIsTakenOff) {
  const TextCoverage coverage = Environment("", {"5 sheep", "Weather: rain"});
  std::vector<std::string> not_understood = {"five sheep in the rain", "sheep of zorblax", "sheep",
                                             "of"};
  TakeOffCarried(coverage, SentenceKind::kEnvironment, Vocabulary::kSuburb, &not_understood);
  EXPECT_EQ(not_understood, (Strings{"sheep of zorblax", "of"}));
}

TEST(CoverageTest, ANumberCountsNothingThatComesAfterAPause) {
  EXPECT_EQ(Layout("Ponds between the two. Forest.", {"Ponds", "Forest"}).lost, Strings());
  EXPECT_EQ(Layout("Ponds between the two, and forest.", {"Ponds", "Forest"}).lost, Strings());
  EXPECT_EQ(Layout("Two little blue ponds. Forest.", {"Ponds", "Forest"}).lost, Strings{"Two"});
}

TEST(CoverageTest, WhatIsLostIsToldOnce) {
  TextCoverage coverage;
  coverage.lost = {"zorblax", "three", "six"};
  std::vector<std::string> not_understood = {"a zorblax"};
  AddLost(coverage, {"\"six lakes\" are more than fit"}, &not_understood);
  EXPECT_EQ(not_understood, (std::vector<std::string>{"a zorblax", "three"}));
}

TEST(QuotedTextTest, IsThePieceThatSaysMostOfTheSentence) {
  const std::string text =
      "Forest fills the left, they say; but on the right, where four huts stand by the lake, "
      "there is none.";
  const auto quote = [&text](const std::string& sentence) {
    return QuotedText(text, SentenceKind::kLayout, Vocabulary::kSuburb).QuoteOf(sentence);
  };
  EXPECT_EQ(quote("Forest fills the western half"), "Forest fills the left");
  EXPECT_EQ(quote("4 huts are near the lake"), "four huts stand by the lake");
  EXPECT_EQ(quote("A railway"), "A railway") << "nothing of the text says it";
}

}  // namespace
}  // namespace latticeworld
