#include "latticeworld/mapping/scan_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "latticeworld/mapping/traversability.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

Scene Level() {
  return MakeScene(64, 32.0, [](double, double) { return 2.0; });
}

std::ptrdiff_t Occupied(const Grid<std::int8_t>& map) {
  return std::count(map.begin(), map.end(), std::int8_t{100});
}

TEST(ScanMapTest, ShowsCropsBushesAndGrassThatReachTheScanAndThatARobotPasses) {
  for (const AssetKind kind : {AssetKind::kCrop, AssetKind::kBush, AssetKind::kGrassTuft}) {
    const Scene high = WithAssets(Level(), {MakeRound(kind, 3.25f, -4.75f, 0.9f, 0.6f)});
    const Grid<std::int8_t> map = BuildScanMap(high);
    const CellIndex cell = high.geometry().CellAt({3.25, -4.75});
    EXPECT_EQ(map[cell], 100);
    EXPECT_EQ(map(cell.row, cell.col + 1), 100);
    EXPECT_EQ(Occupied(map), 5) << "the cell and its four neighbours, 0.5 m away";
    EXPECT_EQ(BuildOccupancy(high, {})[cell], 0);
    const Scene low = WithAssets(Level(), {MakeRound(kind, 3.25f, -4.75f, 0.4f, 0.6f)});
    EXPECT_EQ(Occupied(BuildScanMap(low)), 0);
    EXPECT_EQ(Occupied(BuildScanMap(low, 0.3)), 5);
  }
}

TEST(ScanMapTest, ShowsTrunksAndBuildingsAsTheyStandAndNoLowStones) {
  const Scene scene = WithAssets(
      Level(), {MakeTree(-8.0f, 5.0f, 9.0f, 3.0f, 0.3f), MakeBuilding(6.0f, 6.0f, 5, 3, 2, 0.0f),
                MakeRound(AssetKind::kStone, 0.0f, -9.0f, 0.2f, 1.0f),
                MakeRound(AssetKind::kStone, 5.0f, -9.0f, 1.2f, 1.0f)});
  const Grid<std::int8_t> map = BuildScanMap(scene);
  const auto at = [&](double x_m, double y_m) { return map[scene.geometry().CellAt({x_m, y_m})]; };
  EXPECT_EQ(at(-8.0, 5.0), 100);
  EXPECT_EQ(at(-8.0, 6.5), 0) << "below the crown";
  EXPECT_EQ(at(8.8, 7.8), 100);
  EXPECT_EQ(at(9.4, 7.8), 0) << "nothing is grown";
  EXPECT_EQ(at(0.0, -9.0), 0);
  EXPECT_EQ(at(5.0, -9.0), 100);
}

TEST(ScanMapTest, ShowsNeitherWaterNorSteepGround) {
  const Scene scene =
      WithWater(MakeScene(64, 32.0, [](double x_m, double) { return 2.0 * x_m; }), -5.0f);
  ASSERT_GT(Occupied(BuildOccupancy(scene, {})), 0);
  EXPECT_EQ(Occupied(BuildScanMap(scene)), 0);
}

TEST(ScanMapTest, ShowsNothingThatIsGone) {
  const Scene scene = WithAssets(Level(), {MakeRound(AssetKind::kCrop, 3.0f, 3.0f, 0.9f, 0.6f),
                                           MakeRound(AssetKind::kStone, 0.0f, 0.0f, 0.2f, 0.5f),
                                           MakeTree(-8.0f, 5.0f, 9.0f, 3.0f, 0.3f)});
  SceneChanges changes;
  changes.gone = {0, 2};
  EXPECT_EQ(Occupied(BuildScanMap(scene, kScanHeight_m, changes)), 0);
  EXPECT_GT(Occupied(BuildScanMap(scene)), 0);
}

TEST(ScanMapTest, KeepsWithinTheWorldWhatStandsAtItsEdge) {
  const Scene scene = WithAssets(Level(), {MakeRound(AssetKind::kCrop, 15.9f, -15.9f, 0.9f, 2.0f)});
  EXPECT_GT(Occupied(BuildScanMap(scene)), 4);
}

}  // namespace
}  // namespace latticeworld
