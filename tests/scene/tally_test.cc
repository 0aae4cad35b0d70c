#include "latticeworld/scene/tally.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latticeworld/scene/vegetation/densities.h"
#include "scene/test_world.h"

namespace latticeworld {
namespace {

const KindCount& CountFor(const SceneAnswer& answer, AssetKind kind) {
  return answer.counts[static_cast<std::size_t>(kind)];
}

bool Warns(const SceneAnswer& answer, const std::string& text) {
  return std::any_of(answer.warnings.begin(), answer.warnings.end(),
                     [&](const std::string& w) { return w.find(text) != std::string::npos; });
}

TEST(TallyTest, CountsAreOfWhatIsThereAndWhatTheDensitiesAskFor) {
  for (const auto& vocabulary : EnumNames(Vocabulary{})) {
    const auto terrain = MakePatchwork(vocabulary.value, 2);
    const EnvironmentConfig environment = MakeEnvironment(0.6);
    const SceneAnswer answer = Build(terrain, environment, 2);
    ASSERT_EQ(answer.counts.size(), static_cast<std::size_t>(kAssetKindCount));
    for (const auto& kind : EnumNames(AssetKind{})) {
      EXPECT_EQ(CountFor(answer, kind.value).kind, kind.value);
      EXPECT_EQ(CountFor(answer, kind.value).placed, CountOf(*answer.scene, kind.value));
    }
    const DensityField stones(terrain->weights, environment, *Catalogue::BuiltIn(),
                              AssetKind::kStone, 1.0);
    EXPECT_EQ(CountFor(answer, AssetKind::kStone).wanted,
              std::lround(stones.Expected(terrain->geometry())));
  }
}

TEST(TallyTest, AWorldThatHasRoomForAllDoesNotWarn) {
  for (const char letter : {'A', 'D', 'F', 'G'}) {
    const SceneAnswer answer =
        Build(MakeUniform(Vocabulary::kSuburb, letter), MakeEnvironment(0.7), 4);
    EXPECT_FALSE(Warns(answer, "densities")) << answer.warnings.front();
  }
}

// Meadow and wood by the layout, a flooded plain in truth.
TEST(TallyTest, DensitiesThatWaterHindersAreReported) {
  TestGround ground;
  ground.letter_at = [](WorldPoint point) { return point.x_m < 0.0 ? 'F' : 'G'; };
  ground.water_at_m = [](WorldPoint point) { return point.x_m < 90.0 ? 1.0 : double{NAN}; };
  const SceneAnswer answer = Build(MakeTerrain(ground), MakeEnvironment(1.0), 4);
  const KindCount& trees = CountFor(answer, AssetKind::kTree);
  EXPECT_GT(trees.wanted, 2000);
  EXPECT_LT(trees.placed, 30);
  EXPECT_TRUE(Warns(answer, "placed " + std::to_string(trees.placed) + " of the " +
                                std::to_string(trees.wanted) + " tree assets"));
  EXPECT_TRUE(Warns(answer, "there is water, a road or the edge of the world"));
}

TEST(TallyTest, SteepGroundIsNamedAsTheReason) {
  TestGround ground;
  ground.letter_at = [](WorldPoint) { return 'F'; };
  ground.height_at_m = [](WorldPoint point) { return 1.5 * point.x_m; };
  const SceneAnswer answer = Build(MakeTerrain(ground), MakeEnvironment(1.0), 4);
  EXPECT_EQ(CountFor(answer, AssetKind::kTree).placed, 0);
  EXPECT_TRUE(Warns(answer, "the ground is too steep"));
}

// Few trees have few dead branches below them: that is no shortfall.
TEST(TallyTest, DeadBranchesAreWantedWhereTreesAre) {
  EnvironmentConfig environment = MakeEnvironment(1.0);
  environment.fine_of(AssetType::kForest).density = 0.02;
  const SceneAnswer answer = Build(MakeUniform(Vocabulary::kSuburb, 'F', 512.0), environment, 4);
  EXPECT_LE(CountFor(answer, AssetKind::kDeadBranch).wanted,
            CountFor(answer, AssetKind::kTree).placed);
  EXPECT_FALSE(Warns(answer, "dead_branch"));
}

// Thousands of houses on a plot between roads: as many as fit, and a warning with the numbers.
TEST(TallyTest, MoreBuildingsThanThePlotHoldsAreReported) {
  TestGround ground;
  ground.letter_at = [](WorldPoint point) {
    return std::abs(std::remainder(point.x_m, 16.0)) < 4.0 ? 'R' : 'B';
  };
  const SceneAnswer answer = Build(MakeTerrain(ground), MakeEnvironment(1.0), 4);
  const KindCount& buildings = CountFor(answer, AssetKind::kBuilding);
  EXPECT_LT(buildings.placed, buildings.wanted);
  EXPECT_TRUE(Warns(answer, " building assets that the densities ask for"));
}

TEST(TallyTest, ShortfallsNeedAClearDifference) {
  Tally tally;
  tally.Of(AssetKind::kStone).wanted = 100.0;
  EXPECT_TRUE(tally.Shortfalls({{AssetKind::kStone, 100, 81}}).empty());
  EXPECT_EQ(tally.Shortfalls({{AssetKind::kStone, 100, 79}}).size(), 1u);
  EXPECT_TRUE(tally.Shortfalls({{AssetKind::kStone, 5, 1}}).empty());
  // None at all, and houses that are missing, are told always.
  EXPECT_EQ(tally.Shortfalls({{AssetKind::kStone, 5, 0}})[0],
            "placed 0 of the 5 stone assets that the densities ask for: fewer places suit than the "
            "densities ask for");
  EXPECT_TRUE(tally.Shortfalls({{AssetKind::kStone, 0, 0}}).empty());
  EXPECT_EQ(tally.Shortfalls({{AssetKind::kBuilding, 4, 3}}).size(), 1u);
  EXPECT_TRUE(tally.Shortfalls({{AssetKind::kBuilding, 10, 9}}).empty());
  tally.Of(AssetKind::kStone).Refuse(Refusal::kOccupied);
  EXPECT_EQ(tally.Shortfalls({{AssetKind::kStone, 100, 3}})[0],
            "placed 3 of the 100 stone assets that the densities ask for: at 1 places something "
            "solid stands in the way");
}

}  // namespace
}  // namespace latticeworld
