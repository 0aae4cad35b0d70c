#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/language/drawn/grounded.h"

namespace latticeworld {
namespace {

// Grassland; water in the upper left ninth when `lake`, forest in the lower right one.
SymbolicLayout Meadow(bool lake) {
  SymbolicLayout layout{Vocabulary::kSuburb, Grid<char>(kLayoutSize, kLayoutSize, 'G')};
  for (int row = 0; row < 11; ++row) {
    for (int col = 0; col < 11; ++col) {
      if (lake) layout.cells(row, col) = 'W';
      layout.cells(31 - row, 31 - col) = 'F';
    }
  }
  return layout;
}

EnvironmentAnswer Generate(const std::string& instruction, const SymbolicLayout& layout) {
  EnvironmentRequest request;
  request.instruction = instruction;
  request.layout = &layout;
  request.seed = 1;
  Result<EnvironmentAnswer> answer =
      MakeGroundedEnvironmentGenerator()->Generate(request, Progress());
  EXPECT_TRUE(answer.ok()) << answer.status().ToString();
  EXPECT_TRUE(Validate(answer->environment).empty());
  return std::move(answer).value();
}

std::string AgentsOf(const EnvironmentAnswer& answer) {
  std::string text;
  for (const AgentGroup& group : answer.environment.agents) {
    text += std::to_string(group.quantity) + " " + std::string(NameOf(group.category)) + " " +
            std::string(NameOf(group.state)) + " " + std::string(NameOf(group.position)) + "; ";
  }
  return text;
}

struct AgentSample {
  std::string instruction;
  std::string agents;
};
void PrintTo(const AgentSample& sample, std::ostream* os) { *os << sample.instruction; }

class GroundedAgents : public testing::TestWithParam<AgentSample> {};

TEST_P(GroundedAgents, AreReadWithoutAWarning) {
  const EnvironmentAnswer answer = Generate(GetParam().instruction, Meadow(true));
  EXPECT_EQ(AgentsOf(answer), GetParam().agents);
  for (const std::string& warning : answer.warnings) ADD_FAILURE() << warning;
}

INSTANTIATE_TEST_SUITE_P(
    Voices, GroundedAgents,
    testing::ValuesIn(std::vector<AgentSample>{
        {"An early autumn morning with light fog. Nine sheep graze in the lower left, two goblins "
         "patrol near the upper right, an eagle circles above, and a wheeled robot waits in the "
         "center.",
         "9 sheep grazing lower left; 2 goblin patrolling upper right; 1 eagle flying anywhere; "
         "1 wheeled robot idle center; "},
        {"a pair of horses and a dozen sheep feed in the south",
         "2 horse grazing lower; 12 sheep grazing lower; "},
        {"Forty-two goblins attack in the north-east!", "42 goblin attacking upper right; "},
        {"A herd of horses; several drones hover over the middle right.",
         "8 horse grazing anywhere; 5 aerial robot flying middle right; "},
        {"In the upper left a whale swims.", "1 whale swimming upper left; "},
        {"three knights guard the center, a robot dog follows in the west",
         "3 ancient warrior patrolling center; 1 robotic dog pursuing middle left; "},
        {"5 grazing sheep", "5 sheep grazing anywhere; "},
        {"No sheep, but one humanoid robot stands at the bottom.", "1 humanoid robot idle lower; "},
        {"two goblins in the north and three goblins in the south",
         "2 goblin patrolling upper; 3 goblin patrolling lower; "},
        {"a sunny day", ""},
    }));

struct CoarseSample {
  std::string instruction;
  std::string coarse;  // terrain, season, style, weather, time
};
void PrintTo(const CoarseSample& sample, std::ostream* os) { *os << sample.instruction; }

class GroundedCoarse : public testing::TestWithParam<CoarseSample> {};

TEST_P(GroundedCoarse, AttributesAreReadOrInferred) {
  const CoarseAttributes coarse =
      Generate(GetParam().instruction, Meadow(false)).environment.coarse;
  const std::string text =
      std::string(NameOf(coarse.terrain_type)) + " " + std::string(NameOf(coarse.season)) + " " +
      std::string(NameOf(coarse.artistic_style)) + " " + std::string(NameOf(coarse.weather)) + " " +
      std::string(NameOf(coarse.time_of_day));
  EXPECT_EQ(text, GetParam().coarse);
}

INSTANTIATE_TEST_SUITE_P(
    Voices, GroundedCoarse,
    testing::ValuesIn(std::vector<CoarseSample>{
        {"", "grassland summer realistic sunny day"},
        {"A blizzard at midnight", "grassland winter realistic snow night"},
        {"golden leaves under an overcast sky at sunset", "grassland autumn realistic cloudy dusk"},
        {"A foggy March morning in the mountains", "mountain spring realistic fog morning"},
        {"a cartoon desert at high noon, a sandstorm blows",
         "desert summer cartoon sandstorm noon"},
        {"CYBERPUNK CITY, HEAVY RAIN, NIGHT", "suburb summer cyberpunk rain night"},
        {"snow falls on a spring afternoon", "grassland spring realistic snow afternoon"},
        {"first light over a frozen lake", "grassland winter realistic sunny dawn"},
        {"no rain", "grassland summer realistic sunny day"},
    }));

TEST(GroundedEnvironmentTest, ACorrectionCountsAndIsQuoted) {
  const EnvironmentAnswer answer =
      Generate("A sunny summer noon. No, make it night, and let it rain.", Meadow(false));
  EXPECT_EQ(answer.environment.coarse.time_of_day, TimeOfDay::kNight);
  EXPECT_EQ(answer.environment.coarse.weather, Weather::kRain);
  EXPECT_EQ(answer.environment.coarse.season, Season::kSummer);
  ASSERT_EQ(answer.warnings.size(), 2u);
  EXPECT_NE(answer.warnings[0].find("noon"), std::string::npos) << answer.warnings[0];
  EXPECT_NE(answer.warnings[0].find("night"), std::string::npos) << answer.warnings[0];
  EXPECT_NE(answer.warnings[1].find("sunny"), std::string::npos) << answer.warnings[1];
  EXPECT_NE(answer.warnings[1].find("rain"), std::string::npos) << answer.warnings[1];
}

TEST(GroundedEnvironmentTest, WhereAgentsAreDoesNotChangeTheLand) {
  const EnvironmentAnswer answer =
      Generate("Mountains in the morning. Three sheep graze on a meadow.", Meadow(false));
  EXPECT_EQ(answer.environment.coarse.terrain_type, TerrainType::kMountain);
  EXPECT_TRUE(answer.warnings.empty());
}

TEST(GroundedEnvironmentTest, RefusesAWhaleWithoutOpenWater) {
  const EnvironmentAnswer answer = Generate("a whale swims in the center", Meadow(false));
  EXPECT_TRUE(answer.environment.agents.empty());
  ASSERT_EQ(answer.warnings.size(), 1u);
  EXPECT_NE(answer.warnings[0].find("whale"), std::string::npos);
  EXPECT_NE(answer.warnings[0].find("water"), std::string::npos);
}

TEST(GroundedEnvironmentTest, AWhaleNeedsWideWaterNotMuchOfIt) {
  SymbolicLayout river = Meadow(false);
  for (int row = 0; row < kLayoutSize; ++row) {
    river.cells(row, 4) = 'W';
    river.cells(row, 5) = 'W';
  }
  EXPECT_TRUE(Generate("a whale swims", river).environment.agents.empty());
  SymbolicLayout lake = Meadow(false);
  for (int row = 14; row < 17; ++row) {
    for (int col = 14; col < 17; ++col) lake.cells(row, col) = 'W';
  }
  const EnvironmentAnswer answer = Generate("a whale swims in the north", lake);
  ASSERT_EQ(answer.environment.agents.size(), 1u);
  EXPECT_EQ(answer.environment.agents[0].position, Region::kCenter);
}

TEST(GroundedEnvironmentTest, MovesAgentsToWhereTheyCanLive) {
  const EnvironmentAnswer answer =
      Generate("Six sheep graze in the upper left. A whale swims in the south.", Meadow(true));
  ASSERT_EQ(answer.environment.agents.size(), 2u);
  EXPECT_NE(answer.environment.agents[0].position, Region::kUpperLeft);
  EXPECT_EQ(answer.environment.agents[1].position, Region::kUpperLeft);
  EXPECT_EQ(answer.warnings.size(), 2u);
}

TEST(GroundedEnvironmentTest, NothingGrazesWithoutGrass) {
  const SymbolicLayout desert{Vocabulary::kSuburb, Grid<char>(kLayoutSize, kLayoutSize, 'D')};
  const EnvironmentAnswer answer = Generate("sheep graze", desert);
  ASSERT_EQ(answer.environment.agents.size(), 1u);
  EXPECT_EQ(answer.environment.agents[0].state, AgentState::kIdle);
  EXPECT_EQ(answer.warnings.size(), 1u);
}

TEST(GroundedEnvironmentTest, NearestCategoryAndStateWithAWarning) {
  const EnvironmentAnswer answer = Generate("a wolf hunts; a sheep attacks", Meadow(false));
  ASSERT_EQ(answer.environment.agents.size(), 2u);
  EXPECT_EQ(answer.environment.agents[0].category, AgentCategory::kGoblin);
  EXPECT_TRUE(CanBe(AgentCategory::kSheep, answer.environment.agents[1].state));
  EXPECT_EQ(answer.warnings.size(), 2u);
}

TEST(GroundedEnvironmentTest, AgentsStayWithinTheLimit) {
  const EnvironmentAnswer answer =
      Generate("900 sheep, 700 goblins, a million horses and 12 robots", Meadow(false));
  int total = 0;
  for (const AgentGroup& group : answer.environment.agents) total += group.quantity;
  EXPECT_EQ(total, kMaxAgents);
  // The goblins are cut, the horses and the robots left out.
  EXPECT_EQ(answer.warnings.size(), 3u);
}

TEST(GroundedEnvironmentTest, DensityFollowsTheWords) {
  const SymbolicLayout layout = Meadow(false);
  const auto density = [&](const std::string& text, AssetType type) {
    return Generate(text, layout).environment.fine_of(type).density;
  };
  EXPECT_GT(density("dense forest", AssetType::kForest), density("", AssetType::kForest));
  EXPECT_LT(density("sparse grass", AssetType::kGrass), density("", AssetType::kGrass));
  EXPECT_EQ(density("no flowers", AssetType::kFlower), 0.0);
}

TEST(GroundedEnvironmentTest, WarnsOfWhatItDoesNotUnderstand) {
  const EnvironmentAnswer answer = Generate("a flock of zorblaxes", Meadow(false));
  ASSERT_EQ(answer.warnings.size(), 1u);
  EXPECT_NE(answer.warnings[0].find("zorblaxes"), std::string::npos);
}

TEST(GroundedEnvironmentTest, AnyTextGivesAValidEnvironment) {
  const std::vector<std::string> words = {"sheep",
                                          "9999999",
                                          "whales",
                                          "no",
                                          "attack",
                                          "in",
                                          "the",
                                          "north",
                                          "and",
                                          ",",
                                          ".",
                                          "fog",
                                          "dense",
                                          "forest",
                                          "graze",
                                          "a pair of",
                                          "million",
                                          "robot",
                                          "fly",
                                          "swim",
                                          "\xE2\x80\x99s",
                                          "\xC3\xA9t\xC3\xA9",
                                          "midnight",
                                          "snow",
                                          "summer",
                                          "herd of",
                                          "-",
                                          "goblins",
                                          "patrol"};
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RandomStream random(seed, "salad");
    std::string text;
    const int length = random.UniformInt(0, 80);
    for (int i = 0; i < length; ++i) {
      text += words[random.UniformInt(0, static_cast<int>(words.size()) - 1)] + " ";
    }
    Generate(text, Meadow(random.Chance(0.5)));
  }
}

TEST(GroundedEnvironmentTest, NeedsALayout) {
  const auto answer =
      MakeGroundedEnvironmentGenerator()->Generate(EnvironmentRequest(), Progress());
  ASSERT_FALSE(answer.ok());
  EXPECT_EQ(answer.status().code(), StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace latticeworld
