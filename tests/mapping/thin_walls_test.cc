// Fences and walls that are thinner than voxels and cells.

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <cmath>

#include "latticeworld/mapping/octree/octree.h"
#include "latticeworld/mapping/scan_map.h"
#include "latticeworld/mapping/traversability.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

constexpr float kHalfThick_m = 0.06f, kHalfLong_m = 3.0f;

// A fence of 6 m on a plain, its front along yaw.
Scene WithFence(float yaw_rad) {
  return WithAssets(MakeScene(64, 32.0, [](double, double) { return 0.0; }),
                    {MakeBuilding(0.7f, 0.4f, 1.1f, kHalfThick_m, kHalfLong_m, yaw_rad)});
}

TEST(ThinWallsTest, NoMapHasAGapInAFence) {
  for (const float yaw_rad : {0.0f, 0.3f, 0.7854f, 1.2f, 2.5f}) {
    SCOPED_TRACE(yaw_rad);
    const Scene scene = WithFence(yaw_rad);
    OctreeOptions options;
    const auto tree = BuildOctree(scene, options, Progress()).value();
    const Grid<std::int8_t> occupancy = BuildOccupancy(scene, RobotLimits());
    const Grid<std::int8_t> scanned = BuildScanMap(scene);
    for (double left_m = -2.7; left_m <= 2.7; left_m += 0.1) {
      const WorldPoint at = {0.7 - std::sin(yaw_rad) * left_m, 0.4 + std::cos(yaw_rad) * left_m};
      EXPECT_NE(tree->search(at.x_m, at.y_m, 0.6), nullptr) << left_m;
      EXPECT_EQ(occupancy[scene.geometry().CellAt(at)], 100) << left_m;
      EXPECT_EQ(scanned[scene.geometry().CellAt(at)], 100) << left_m;
    }
  }
}

TEST(ThinWallsTest, AFenceIsNoWiderThanTheVoxelsThatItGoesThrough) {
  const Scene scene = WithFence(0.0f);
  const auto tree = BuildOctree(scene, OctreeOptions(), Progress()).value();
  for (const double away_m : {1.0, -1.0}) {
    const octomap::OcTreeNode* node = tree->search(0.7 + away_m, 0.4, 0.6);
    EXPECT_TRUE(node == nullptr || !tree->isNodeOccupied(node)) << away_m;
  }
}

}  // namespace
}  // namespace latticeworld
