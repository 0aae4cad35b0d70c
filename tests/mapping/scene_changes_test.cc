#include "latticeworld/mapping/scene_changes.h"

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <cmath>

#include "latticeworld/mapping/octree.h"
#include "latticeworld/mapping/traversability.h"
#include "scene_of_everything.h"
#include "voxels_of.h"

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

TEST(SceneChangesTest, WhatIsGoneLeavesNoTrace) {
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

TEST(SceneChangesTest, ATreeThatFallsIsNoLongerWhereItStoodAndLiesWhereItFell) {
  const Scene scene = OneTree();
  const auto standing = BuildOctree(scene, {0.5, 1.0}, Progress()).value();
  const SceneChanges changes = {{{0, 0.0}}, {}};  // toward the east
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

TEST(SceneChangesTest, AFallenTreeLooksTheSameWhateverItsHeading) {
  const Scene scene = OneTree();
  const auto count = [&](double heading_rad) {
    return VoxelsOf(*BuildOctree(scene, {0.1, 0.0}, Progress(), {{{0, heading_rad}}, {}}).value())
        .size();
  };
  const double east = static_cast<double>(count(0.0));
  for (double heading_rad = 0.4; heading_rad < 2.0 * kPi; heading_rad += 0.7)
    EXPECT_NEAR(static_cast<double>(count(heading_rad)), east, 0.01 * east) << heading_rad;
}

TEST(SceneChangesTest, AFallenTrunkBlocksAsItLies) {
  const Scene scene = OneTree();
  RobotLimits limits;
  limits.radius_m = 0.0;
  limits.clearance_m = 0.0;
  const SceneChanges changes = {{{0, kPi / 2.0}}, {}};  // toward the north
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

TEST(SceneChangesTest, NamesEverythingThatIsWrong) {
  const Scene scene = OneTree();
  EXPECT_TRUE(Validate(SceneChanges{{{0, 1.0}}, {}}, scene).ok());
  EXPECT_EQ(Validate(SceneChanges{{{1, 1.0}}, {7}}, scene).violations().size(), 2u);
  EXPECT_EQ(Validate(SceneChanges{{{0, 1.0}}, {0}}, scene).violations().size(), 1u);
  EXPECT_EQ(Validate(SceneChanges{{{0, std::nan("")}}, {}}, scene).violations().size(), 1u);
  const Scene bushes = WithAssets(OneTree(), {MakeRound(AssetKind::kBush, 0, 0, 1.0f, 1.0f)});
  const Status status = Validate(SceneChanges{{{0, 0.0}}, {}}, bushes);
  EXPECT_NE(status.message().find("bush"), std::string::npos) << status.message();
  EXPECT_EQ(BuildOctree(bushes, {}, Progress(), {{{0, 0.0}}, {}}).status().code(),
            StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace latticeworld
