#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <cmath>

#include "latticeworld/mapping/octree/octree.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/scene/scene_changes.h"
#include "mapping/scene_of_everything.h"
#include "mapping/voxels_of.h"

namespace latticeworld {
namespace {

constexpr double kPi = 3.14159265358979;

std::vector<std::int8_t> Bytes(const Scene& scene, const SceneChanges& changes) {
  return BuildBinaryData(scene, {0.5, 1.0}, Progress(), changes).value().bytes;
}

Scene Without(const Scene& scene, std::uint32_t asset) {
  Scene rest = scene;
  rest.assets.erase(rest.assets.begin() + asset);
  rest.index = AssetIndex(rest.geometry().size_m(), rest.assets);
  return rest;
}

// A meadow with one tree of 8 m.
Scene OneTree() {
  return WithAssets(MakeScene(64, 32.0, [](double, double) { return 0.1; }),
                    {MakeTree(0.25f, 0.25f, 8.0f, 2.0f, 0.3f)});
}

// The tree of that scene, lying on level ground with its foot where it stood.
FallenTree Toward(const Scene& scene, double heading_rad, double lean_rad = 0.5 * kPi,
                  std::uint32_t asset = 0) {
  const Asset& tree = scene.assets[asset];
  const Eigen::Vector3d foot(tree.x_m, tree.y_m, tree.z_m + tree.trunk_radius_m);
  const Eigen::Vector3d way(std::sin(lean_rad) * std::cos(heading_rad),
                            std::sin(lean_rad) * std::sin(heading_rad), std::cos(lean_rad));
  return {asset, foot, foot + tree.height_m * way};
}

TEST(ChangedMapsTest, WhatIsGoneLeavesNoTrace) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Scene scene = SceneOfEverything(seed);
    for (std::uint32_t asset = 0; asset < scene.assets.size(); ++asset) {
      const SceneChanges changes = {{}, {asset}};
      const Scene rest = Without(scene, asset);
      EXPECT_EQ(Bytes(scene, changes), Bytes(rest, {})) << seed << " " << asset;
      EXPECT_EQ(BuildOccupancy(scene, {}, changes), BuildOccupancy(rest, {}));
      EXPECT_EQ(BuildTraversability(scene, {}, changes), BuildTraversability(rest, {}));
    }
  }
}

TEST(ChangedMapsTest, ATreeThatFallsIsNoLongerWhereItStoodAndLiesWhereItFell) {
  const Scene scene = OneTree();
  const auto standing = BuildOctree(scene, {0.5, 1.0}, Progress()).value();
  const SceneChanges changes = {{Toward(scene, 0.0)}, {}};
  const auto fallen = BuildOctree(scene, {0.5, 1.0}, Progress(), changes).value();
  EXPECT_NE(standing->search(0.25, 0.25, 4.0), nullptr);
  EXPECT_EQ(fallen->search(0.25, 0.25, 4.0), nullptr);
  for (double x_m = 0.25; x_m < 5.0; x_m += 0.5)  // the trunk
    EXPECT_NE(fallen->search(x_m, 0.25, 0.4), nullptr) << x_m;
  EXPECT_NE(fallen->search(5.25, 1.25, 1.2), nullptr);  // the crown
  EXPECT_EQ(standing->search(5.25, 1.25, 1.2), nullptr);
  EXPECT_EQ(fallen->search(-1.25, 0.25, 0.6), nullptr);  // nothing behind the foot
  // Not a voxel more below the ground than without the tree.
  const Voxels ground = VoxelsOf(*BuildOctree(scene, {0.5, 1.0}, Progress(), {{}, {0}}).value());
  for (const VoxelKey& key : VoxelsOf(*fallen)) {
    if (key[2] > 32768) continue;
    EXPECT_EQ(ground.count(key), 1u) << key[0] << " " << key[1] << " " << key[2];
  }
}

TEST(ChangedMapsTest, AFallenTreeLooksTheSameWhateverItsHeading) {
  const Scene scene = OneTree();
  const auto count = [&](double heading_rad) {
    const SceneChanges changes = {{Toward(scene, heading_rad)}, {}};
    return VoxelsOf(*BuildOctree(scene, {0.1, 0.0}, Progress(), changes).value()).size();
  };
  const double east = static_cast<double>(count(0.0));
  for (double heading_rad = 0.4; heading_rad < 2.0 * kPi; heading_rad += 0.7)
    EXPECT_NEAR(static_cast<double>(count(heading_rad)), east, 0.01 * east) << heading_rad;
}

TEST(ChangedMapsTest, AFallenTrunkBlocksAsItLies) {
  const Scene scene = OneTree();
  RobotLimits limits;
  limits.radius_m = 0.0;
  limits.clearance_m = 0.0;
  const SceneChanges changes = {{Toward(scene, kPi / 2.0)}, {}};
  const auto occupancy = BuildOccupancy(scene, limits, changes);
  const auto at = [&](double x_m, double y_m) {
    return occupancy[scene.geometry().CellAt({x_m, y_m})];
  };
  for (double y_m = 0.25; y_m < 5.2; y_m += 0.5) EXPECT_EQ(at(0.25, y_m), 100) << y_m;
  EXPECT_EQ(at(0.25, 6.25), 0);
  EXPECT_EQ(at(0.25, -0.75), 0);
  EXPECT_EQ(at(1.25, 2.25), 0);
  // Its crown is in the way of what has a height.
  limits.clearance_m = 0.5;
  const auto with_crown = BuildOccupancy(scene, limits, changes);
  EXPECT_EQ(with_crown[scene.geometry().CellAt({1.25, 5.25})], 100);
  EXPECT_EQ(with_crown[scene.geometry().CellAt({3.25, 5.25})], 0);
}

TEST(ChangedMapsTest, ATreeLiesWhereItSlidAndNotWhereItStood) {
  const Scene scene = OneTree();
  FallenTree tree = Toward(scene, 0.0);
  tree.foot_m.y() += 4.0;
  tree.tip_m.y() += 4.0;
  const auto octree = BuildOctree(scene, {0.5, 1.0}, Progress(), {{tree}, {}}).value();
  EXPECT_NE(octree->search(2.25, 4.25, 0.6), nullptr);
  EXPECT_EQ(octree->search(2.25, 0.25, 0.6), nullptr);
  EXPECT_EQ(octree->search(0.25, 0.25, 2.0), nullptr);
}

TEST(ChangedMapsTest, ATreeThatLeansLetsThroughBelowItsStem) {
  const Scene scene = OneTree();
  const SceneChanges changes = {{Toward(scene, 0.0, kPi / 4.0)}, {}};  // at 45 degrees
  const auto octree = BuildOctree(scene, {0.25, 1.0}, Progress(), changes).value();
  for (double along_m = 0.4; along_m < 3.4; along_m += 0.5)
    EXPECT_NE(octree->search(0.25 + along_m, 0.25, 0.4 + along_m), nullptr) << along_m;
  EXPECT_EQ(octree->search(2.625, 0.375, 0.7), nullptr);
  RobotLimits limits;
  limits.radius_m = 0.0;
  limits.clearance_m = 0.3;
  const auto occupancy = BuildOccupancy(scene, limits, changes);
  const auto at = [&](double x_m) { return occupancy[scene.geometry().CellAt({x_m, 0.25})]; };
  EXPECT_EQ(at(0.25), 100);
  EXPECT_EQ(at(2.75), 0);
}

TEST(ChangedMapsTest, WhatCannotHaveFallenMakesNoOctree) {
  const FallenTree tree = Toward(OneTree(), 1.0);
  const Scene bushes = WithAssets(OneTree(), {MakeRound(AssetKind::kBush, 0, 0, 1.0f, 1.0f)});
  EXPECT_EQ(BuildOctree(bushes, {}, Progress(), {{tree}, {}}).status().code(),
            StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace latticeworld
