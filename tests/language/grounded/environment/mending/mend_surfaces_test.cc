#include "latticeworld/language/grounded/environment/mending/mend_surfaces.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "language/grounded/environment/environment_country.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/language/grounded/environment/mending/amounts/mend_each.h"

namespace latticeworld {
namespace {

std::string MendedBy(void (*mend)(const EnvironmentWords&, std::vector<Token>*),
                     std::string_view text) {
  std::vector<Token> tokens = Tokenize(text);
  mend(GetEnvironmentWords(), &tokens);
  return JoinWords(tokens, 0, tokens.size());
}

void ExpectKept(void (*mend)(const EnvironmentWords&, std::vector<Token>*),
                std::initializer_list<const char*> texts) {
  for (const char* text : texts) EXPECT_EQ(MendedBy(mend, text), text);
}

std::vector<EnvironmentClaim> ClaimsOf(const char* text) {
  const SymbolicLayout layout = Country();
  return ReadEnvironmentInstruction(text, &layout, *Catalogue::BuiltIn()).claims;
}

// The bounds of the first claim of the kind; {-1, -1}: there is none.
std::pair<double, double> Bounds(const char* text, EnvironmentClaimKind kind, AssetType asset) {
  for (const EnvironmentClaim& claim : ClaimsOf(text))
    if (claim.kind == kind && claim.asset == asset) return {claim.least, claim.most};
  return {-1.0, -1.0};
}

TEST(MendSurfacesTest, WetStonesAreNoRain) {
  EXPECT_EQ(MendedBy(MendSurfaces, "wet, mossy stones"), "mossy stones");
  EXPECT_EQ(MendedBy(MendSurfaces, "rocks, mossy and wet"), "rocks , mossy");
  ExpectKept(MendSurfaces,
             {"a wet day , mossy stones", "mossy , wet weather",
              "the road is wet and mossy rocks lie here", "it is wet , mossy stones lie around"});
}

TEST(MendSurfacesTest, SheetsOfIceCoverWater) {
  EXPECT_EQ(MendedBy(MendSurfaces, "a thick layer of ice covers the pond"),
            "the pond is covered with ice");
  EXPECT_EQ(MendedBy(MendSurfaces, "sheets of ice on the lake"), "the lake is covered with ice");
  ExpectKept(MendSurfaces, {"sheets of paper", "a layer of snow covers the road",
                            "no layer of ice is on the pond", "under a sheet of ice a whale swims",
                            "two whales break the layer of ice on the lake"});
}

TEST(MendSurfacesTest, WhatIsLeftOutIsSaidBefore) {
  EXPECT_EQ(MendedBy(MendSurfaces, "the grass is not sparse, but the flowers are"),
            "the grass is not sparse , but the flowers are sparse");
  ExpectKept(MendSurfaces, {"the grass is not tall but the sheep are",
                            "the grass is dense but the forest is not"});
}

TEST(MendSurfacesTest, SharesOfTheLand) {
  EXPECT_EQ(MendedBy(MendSurfaces, "stones cover a quarter of the ground"),
            "stones cover 25 percent of the ground");
  EXPECT_EQ(MendedBy(MendSurfaces, "trees less than a third"), "trees less than 33 percent");
  ExpectKept(MendSurfaces, {"half of the sheep sleep", "two thirds of the drones fly",
                            "half of the world sleeps , the ground is covered with snow"});
  using Pair = std::pair<double, double>;
  const auto density = EnvironmentClaimKind::kDensity;
  EXPECT_EQ(Bounds("Over 70% flowers.", density, AssetType::kFlower), Pair(0.7, 1.0));
  EXPECT_EQ(Bounds("At most 20 percent dead branches.", density, AssetType::kDeadBranch),
            Pair(0.0, 0.2));
  EXPECT_EQ(Bounds("70% grass, 30% forest", density, AssetType::kGrass), Pair(-1.0, -1.0));
  EXPECT_EQ(Bounds("80% humidity, flowers", density, AssetType::kFlower), Pair(-1.0, -1.0));
  EXPECT_EQ(Bounds("Grass is dense, shrubs 40 percent.", density, AssetType::kGrass),
            Pair(0.65, 1.0));
  EXPECT_NEAR(
      Bounds("Houses 30% smaller.", EnvironmentClaimKind::kParameter, AssetType::kArchitecture)
          .first,
      0.63, 1e-9);
}

TEST(MendSurfacesTest, EachAngleIsOfItsClause) {
  const char* text = "Houses rotated 45 degrees, slopes of 40 degrees.";
  using Pair = std::pair<double, double>;
  const auto parameter = EnvironmentClaimKind::kParameter;
  EXPECT_EQ(Bounds(text, parameter, AssetType::kArchitecture), Pair(30.0, 60.0));
  EXPECT_EQ(Bounds(text, parameter, AssetType::kSnowMountain), Pair(35.0, 45.0));
  EXPECT_EQ(Bounds("Houses on a 30 degree slope.", parameter, AssetType::kSnowMountain),
            Pair(25.0, 35.0));
}

TEST(MendSurfacesTest, WhereAgentsAct) {
  EXPECT_EQ(MendedBy(MendSurfaces, "the lake is under siege by goblins"),
            "the lake is besieged by goblins");
  EXPECT_EQ(MendedBy(MendSurfaces, "over the forest hang two eagles"),
            "over the forest two eagles hovering");
  EXPECT_EQ(MendedBy(MendSurfaces, "drones hang over the lake"), "drones hover over the lake");
  ExpectKept(MendSurfaces, {"people hang around", "three eagles hang out by the lake",
                            "two drones hang in the trees", "from the tree hang three eagles",
                            "fog hangs over the lake", "the village is under attack"});
}

TEST(MendEachTest, BandsAreMultiplied) {
  EXPECT_EQ(MendedBy(MendEach, "three flocks of sheep, 12 animals each"), "36 sheep");
  EXPECT_EQ(MendedBy(MendEach, "five squads, each of ten knights"), "50 knights");
  EXPECT_EQ(MendedBy(MendEach, "4 teams with 3 drones each patrol"), "12 drones patrol");
  EXPECT_EQ(MendedBy(MendEach, "6 drones per squad, 2 squads"), "12 drones");
  EXPECT_EQ(MendedBy(MendEach, "a rover in each quarter"), "4 rovers in all four corners");
  ExpectKept(MendEach, {"two teams of four rovers each ; one team sleeps",
                        "two herds of sheep , ten each , one by the lake , one in the fields",
                        "two groups of goblins , one with 4 and one with 6",
                        "ten horses , each with a rider", "a drone over each village"});
}

// Which state the first agents are asked for; nothing: none.
std::optional<AgentState> StateOf(const char* text) {
  for (const EnvironmentClaim& claim : ClaimsOf(text))
    if (claim.kind == EnvironmentClaimKind::kAgents && !claim.states.empty())
      return claim.states.front();
  return std::nullopt;
}

TEST(MendSurfacesTest, RobotsChargeAtStationsAndAtFoes) {
  EXPECT_EQ(StateOf("Three rovers are charging at their base."), AgentState::kIdle);
  EXPECT_EQ(StateOf("Three rovers are charging at the village."), AgentState::kAttacking);
  EXPECT_EQ(StateOf("Three drones, not on the ground."), AgentState::kFlying);
  EXPECT_EQ(StateOf("Three drones on the ground."), AgentState::kIdle);
}

}  // namespace
}  // namespace latticeworld
