#include "latticeworld/scene/vegetation/thinning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>

#include "latticeworld/scene/placement.h"
#include "latticeworld/scene/vegetation/fields.h"
#include "scene/test_world.h"

namespace latticeworld {
namespace {

OfKinds Counts(double trees, double tufts, double buildings) {
  OfKinds counts{};
  counts[static_cast<std::size_t>(AssetKind::kTree)] = trees;
  counts[static_cast<std::size_t>(AssetKind::kGrassTuft)] = tufts;
  counts[static_cast<std::size_t>(AssetKind::kBuilding)] = buildings;
  return counts;
}

TEST(ThinningTest, CoverGivesWayFirstThenTreesAndBuildingsNever) {
  struct Case {
    double trees, tufts, buildings, of_trees, of_tufts;
  };
  for (const Case& item :
       {Case{400.0, 500.0, 100.0, 1.0, 1.0}, Case{400.0, 1000.0, 100.0, 1.0, 0.5},
        Case{400.0, 5000.0, 100.0, 1.0, 0.1}, Case{800.0, 10000.0, 100.0, 0.5, 0.05},
        Case{400.0, 500.0, 2000.0, 0.0, 0.0}}) {
    const Thinning thinning(Counts(item.trees, item.tufts, item.buildings), 1000.0);
    EXPECT_DOUBLE_EQ(thinning[AssetKind::kTree], item.of_trees);
    EXPECT_DOUBLE_EQ(thinning[AssetKind::kStone], item.of_trees);
    EXPECT_DOUBLE_EQ(thinning[AssetKind::kGrassTuft], item.of_tufts);
    EXPECT_DOUBLE_EQ(thinning[AssetKind::kCrop], item.of_tufts);
    EXPECT_EQ(thinning[AssetKind::kBuilding], 1.0);
  }
}

// Gardens and orchards are in what is expected: no more than a tenth above it comes to be.
TEST(ThinningTest, NoMoreIsPlacedThanWasExpected) {
  const auto catalogue = Catalogue::BuiltIn();
  TestGround farms;
  farms.size_m = 512.0;
  farms.letter_at = [](WorldPoint point) { return point.x_m < -150.0 ? 'B' : 'A'; };
  for (const auto& terrain : {MakeUniform(Vocabulary::kSuburb, 'B', 512.0), MakeTerrain(farms)}) {
    for (const double density : {0.2, 1.0}) {
      const EnvironmentConfig environment = MakeEnvironment(density);
      Placement placement(*terrain, *catalogue, environment, 3, 0);
      placement.fields = std::make_shared<const FieldPlan>(placement);
      const OfKinds expected = ExpectedAssets(placement);
      const auto placed = static_cast<double>(Build(terrain, environment, 3).scene->assets.size());
      EXPECT_LE(placed, 1.1 * std::accumulate(expected.begin(), expected.end(), 0.0));
    }
  }
}

TEST(ThinningTest, NoWorldHoldsMoreThanTheMostAndWhatIsLeftOutIsCounted) {
  const auto terrain = MakeUniform(Vocabulary::kSuburb, 'G');
  const EnvironmentConfig environment = MakeEnvironment(1.0);
  Placement placement(*terrain, *Catalogue::BuiltIn(), environment, 1, 1);
  placement.assets.resize(kMaxAssets - 1);
  for (int i = 0; i < 3; ++i) AddAsset(&placement, MakeAsset(placement, AssetKind::kTree));
  EXPECT_EQ(placement.assets.size(), static_cast<std::size_t>(kMaxAssets));
  EXPECT_EQ(placement.left_out, 2);
}

}  // namespace
}  // namespace latticeworld
