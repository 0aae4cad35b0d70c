#include "latticeworld/language/reading/environment_of_sentences.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "latticeworld/language/sentences/sentence.h"

namespace latticeworld {
namespace {

HeardEnvironment Read(const std::string& text) {
  return EnvironmentOfSentences(SplitSentences(text));
}

TEST(EnvironmentOfSentencesTest, CoarseAttributes) {
  const HeardEnvironment heard = Read("Season: winter. Weather: rain or snow. Time: not night.");
  EXPECT_EQ(heard.coarse_of(CoarseKey::kSeason).value, "winter");
  EXPECT_EQ(heard.coarse_of(CoarseKey::kWeather).value, "rain");
  EXPECT_EQ(heard.coarse_of(CoarseKey::kWeather).also, std::vector<std::string>{"snow"});
  EXPECT_EQ(heard.coarse_of(CoarseKey::kTimeOfDay).ruled_out, std::vector<std::string>{"night"});
  EXPECT_EQ(heard.coarse_of(CoarseKey::kTimeOfDay).value, "");
}

TEST(EnvironmentOfSentencesTest, TheLaterOfTwoThatCannotBothBeCounts) {
  const HeardEnvironment heard = Read("Weather: rain. Weather: fog.");
  EXPECT_EQ(heard.coarse_of(CoarseKey::kWeather).value, "fog");
  ASSERT_EQ(heard.warnings.size(), 1u);
  EXPECT_NE(heard.warnings[0].find("Weather: rain"), std::string::npos);
  EXPECT_NE(heard.warnings[0].find("Weather: fog"), std::string::npos);
}

TEST(EnvironmentOfSentencesTest, NumbersOutOfRangeAreSaidAndTheNearestIsTaken) {
  for (const char* text : {"Wind: 300 m/s.", "Building scale: 0.",
                           "Snow slope: at least 200 degrees.", "Stones density: 120 %."}) {
    const HeardEnvironment heard = Read(text);
    ASSERT_EQ(heard.warnings.size(), 1u) << text;
    EXPECT_NE(heard.warnings[0].find("is out of range"), std::string::npos) << heard.warnings[0];
    ASSERT_EQ(heard.fine.size(), 1u) << text;
    EXPECT_TRUE(Validate(heard.fine[0].claim).empty()) << text;
  }
  EXPECT_TRUE(Read("Wind: 12 m/s. Stones density: at least 90 %.").warnings.empty());
}

TEST(EnvironmentOfSentencesTest, EveryValueOfTheLanguageIsOneOfTheCatalogue) {
  for (const char* text : {"Grass: lush.",
                           "Grass: meadow mix.",
                           "Flowers: poppy.",
                           "Branches: driftwood.",
                           "Stones: mossy.",
                           "Buildings: brick.",
                           "Roads: asphalt.",
                           "Lake: frozen.",
                           "Lake: silty.",
                           "Desert: spring bloom.",
                           "Desert: clay.",
                           "Forest: pine.",
                           "Forest: autumn birch.",
                           "Forest: bare.",
                           "Forest: mossy bark.",
                           "Crops: stubble.",
                           "Crops: wheat.",
                           "Snow: firn.",
                           "Snow: ice.",
                           "Grass: not dry."}) {
    const HeardEnvironment heard = Read(text);
    ASSERT_EQ(heard.fine.size(), 1u) << text;
    EXPECT_TRUE(Validate(heard.fine[0].claim).empty()) << text;
  }
  EXPECT_EQ(Read("Forest: pine.").fine[0].claim.values.size(), 4u) << "of every season";
  EXPECT_EQ(Read("Grass: not dry.").fine[0].claim.values,
            (std::vector<std::string>{"lush", "snow-covered"}));
  EXPECT_EQ(Read("Grass: asphalt.").warnings.size(), 1u);
}

TEST(EnvironmentOfSentencesTest, Numbers) {
  const auto claim = [](const std::string& text) { return Read(text).fine.at(0).claim; };
  EXPECT_NEAR(claim("Wind: at least 10 m/s.").least, 10.0, 1e-9);
  EXPECT_NEAR(claim("Wind: at least 10 m/s.").most, 40.0, 1e-9);
  EXPECT_NEAR(claim("Lake level: -0.3 m.").least, -0.4, 1e-9);
  EXPECT_NEAR(claim("Forest density: 70 %.").least, 0.62, 1e-9);
  EXPECT_NEAR(claim("Stones density: none.").most, 0.0, 1e-9);
  EXPECT_NEAR(claim("Building scale: 99.").most, 4.0, 1e-9) << "within what is legal";
}

TEST(EnvironmentOfSentencesTest, Agents) {
  const HeardEnvironment heard = Read(
      "12 sheep grazing in the south-west. At least 3 robotic dogs patrolling in the village. "
      "2 to 4 sheep or horses by the lake. Some goblins. 1 eagle idle or flying.");
  ASSERT_EQ(heard.agents.size(), 5u);
  EXPECT_EQ(heard.agents[0].quantity, 12);
  EXPECT_EQ(heard.agents[0].state, AgentState::kGrazing);
  ASSERT_EQ(heard.agents[0].places.size(), 1u);
  EXPECT_EQ(heard.agents[0].places[0].main, Region::kLowerLeft);
  EXPECT_EQ(heard.agents[1].least, 3);
  EXPECT_EQ(heard.agents[1].feature->name, "village");
  EXPECT_EQ(heard.agents[2].categories,
            (std::vector<AgentCategory>{AgentCategory::kSheep, AgentCategory::kHorse}));
  EXPECT_TRUE(heard.agents[2].feature->near);
  EXPECT_FALSE(heard.agents[3].counted);
  EXPECT_EQ(heard.agents[4].state, AgentState::kIdle) << "either will do, the first is taken";
}

TEST(EnvironmentOfSentencesTest, WhatIsHeardInPartIsSaid) {
  const HeardEnvironment heard = Read("2 goblins away from the village.");
  ASSERT_EQ(heard.warnings.size(), 1u);
  EXPECT_NE(heard.warnings[0].find("2 goblins away from the village"), std::string::npos);
}

TEST(EnvironmentOfSentencesTest, LandInAPartOfTheMap) {
  const HeardEnvironment heard = Read("7 robotic dogs idle on the rock in the west.");
  ASSERT_EQ(heard.agents.size(), 1u);
  EXPECT_EQ(heard.agents[0].feature->name, "rock");
  ASSERT_EQ(heard.agents[0].places.size(), 1u);
  EXPECT_EQ(heard.agents[0].places[0].main, Region::kMiddleLeft);
}

TEST(EnvironmentOfSentencesTest, NobodyAndTotals) {
  const HeardEnvironment heard = Read("No goblins. No agents. 20 agents in all.");
  ASSERT_EQ(heard.absences.size(), 3u);
  EXPECT_EQ(heard.absences[0].categories, std::vector<AgentCategory>{AgentCategory::kGoblin});
  EXPECT_TRUE(heard.absences[1].categories.empty());
  EXPECT_EQ(heard.absences[2].kind, EnvironmentClaimKind::kTotalAgents);
  EXPECT_EQ(heard.absences[2].most_quantity, 20);
}

TEST(EnvironmentOfSentencesTest, WhatIsNoSentenceIsNotUnderstood) {
  EXPECT_EQ(Read("Season: winter. What a day.").not_understood,
            std::vector<std::string>{"What a day"});
}

}  // namespace
}  // namespace latticeworld
