#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/mapping/octree/octree.h"
#include "mapping/octree/tree_data.h"
#include "mapping/scene_of_everything.h"
#include "mapping/voxels_of.h"

namespace latticeworld {
namespace {

Voxels Restricted(const Voxels& voxels, const MapBox& box, double voxel_m) {
  const octomap::OcTree keys(voxel_m);
  const auto low = keys.coordToKey(box.x_m - box.half_length_m, box.y_m - box.half_width_m,
                                   box.z_m - box.half_height_m);
  const auto high = keys.coordToKey(box.x_m + box.half_length_m, box.y_m + box.half_width_m,
                                    box.z_m + box.half_height_m);
  Voxels inside;
  for (const VoxelKey& key : voxels) {
    bool is_inside = true;
    for (int axis = 0; axis < 3; ++axis)
      is_inside &= low[axis] <= key[axis] && key[axis] <= high[axis];
    if (is_inside) inside.insert(key);
  }
  return inside;
}

TEST(OctreeBoxTest, IsTheWholeTreeRestrictedToTheVoxelsThatTheBoxTouches) {
  int partial = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Scene scene = SceneOfEverything(seed);
    RandomStream random(seed, "boxes");
    for (const double voxel_m : {0.5, 0.23}) {
      const Voxels whole = VoxelsOf(*BuildOctree(scene, {voxel_m, 1.0}, Progress()).value());
      for (int i = 0; i < 8; ++i) {
        const MapBox box = {random.Uniform(-18.0, 18.0), random.Uniform(-18.0, 18.0),
                            random.Uniform(-4.0, 8.0),   random.Uniform(0.0, 12.0),
                            random.Uniform(0.0, 12.0),   random.Uniform(0.0, 6.0)};
        const OctreeOptions options = {voxel_m, 1.0, box};
        const auto tree = BuildOctree(scene, options, Progress()).value();
        const Voxels expected = Restricted(whole, box, voxel_m);
        EXPECT_EQ(VoxelsOf(*tree), expected) << seed << " box " << i << " at " << voxel_m;
        partial += !expected.empty() && expected.size() < whole.size();
        EXPECT_EQ(BuildBinaryData(scene, options, Progress()).value().bytes,
                  BinaryData(*tree).bytes);
        EXPECT_EQ(BuildFullData(scene, options, Progress()).value().bytes, FullData(*tree).bytes);
      }
    }
  }
  EXPECT_GT(partial, 40);
}

TEST(OctreeBoxTest, ABoxThatHoldsTheWorldIsTheWholeWorld) {
  const Scene scene = SceneOfEverything(1);
  const MapBox box = {0.0, 0.0, 0.0, 100.0, 100.0, 1000.0};
  EXPECT_EQ(BuildFullData(scene, {0.5, 1.0, box}, Progress()).value().bytes,
            BuildFullData(scene, {0.5, 1.0}, Progress()).value().bytes);
}

TEST(OctreeBoxTest, WhereNothingIsOccupiedThereIsNoTree) {
  const Scene scene = SceneOfEverything(1);
  for (const MapBox& box :
       {MapBox{100.0, 0.0, 0.0, 5.0, 5.0, 50.0}, MapBox{0.0, 0.0, 500.0, 5.0, 5.0, 5.0},
        MapBox{0.0, 0.0, -500.0, 5.0, 5.0, 5.0}}) {
    const auto tree = BuildOctree(scene, {0.5, 1.0, box}, Progress());
    ASSERT_TRUE(tree.ok()) << tree.status().ToString();
    EXPECT_EQ((*tree)->size(), 0u);
    EXPECT_EQ((*tree)->getRoot(), nullptr);
    const OctreeData data = BuildBinaryData(scene, {0.5, 1.0, box}, Progress()).value();
    EXPECT_TRUE(data.bytes.empty());
    EXPECT_EQ(data.nodes, 0u);
  }
}

// 0.05 m over a kilometre would be 20,000 columns a side; a robot's surroundings are 400.
TEST(OctreeBoxTest, FineVoxelsOverAWideWorldAreRefusedAndABoxOfThemWorks) {
  const Scene scene = MakeScene(
      100, 1000.0, [](double x_m, double y_m) { return 20.0 * std::sin(x_m / 90.0) + 0.01 * y_m; });
  const auto refused = BuildBinaryData(scene, {0.05, 0.2}, Progress());
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().code(), StatusCode::kInvalidArgument);
  EXPECT_NE(refused.status().message().find("a box with half extents up to"), std::string::npos)
      << refused.status().message();

  const MapBox box = {-321.0, 456.0, scene.terrain->ground.HeightAt({-321.0, 456.0}),
                      10.0,   10.0,  5.0};
  const auto tree = BuildOctree(scene, {0.05, 0.2, box}, Progress());
  ASSERT_TRUE(tree.ok()) << tree.status().ToString();
  RandomStream random(1, "points");
  for (int i = 0; i < 500; ++i) {
    const WorldPoint p = {box.x_m + random.Uniform(-10.0, 10.0),
                          box.y_m + random.Uniform(-10.0, 10.0)};
    const double height_m = scene.terrain->ground.HeightAt(p);
    bool occupied = false;
    for (const double offset_m : {-0.05, 0.0, 0.05})
      occupied |= (*tree)->search(p.x_m, p.y_m, height_m + offset_m) != nullptr;
    EXPECT_TRUE(occupied);
    EXPECT_EQ((*tree)->search(p.x_m, p.y_m, height_m + 0.15), nullptr);
    EXPECT_EQ((*tree)->search(p.x_m, p.y_m, height_m - 0.55), nullptr);
  }
}

TEST(OctreeBoxTest, FarFromTheOriginOctomapsKeysAreTheLimit) {
  const Scene scene = MakeScene(64, 8192.0, [](double, double) { return 3.0; });
  const auto build = [&](double x_m, double voxel_m) {
    return BuildBinaryData(scene, {voxel_m, 0.2, MapBox{x_m, 0.0, 0.0, 5.0, 5.0, 5.0}}, Progress());
  };
  EXPECT_TRUE(build(1600.0, 0.05).ok());
  EXPECT_FALSE(build(1700.0, 0.05).ok());
  EXPECT_TRUE(build(1700.0, 0.06).ok());
  EXPECT_TRUE(build(4090.0, 0.2).ok());
}

TEST(OctreeBoxTest, RefusesBoxesWithoutAPlaceOrExtent) {
  const Scene scene = SceneOfEverything(1);
  const double nan = std::nan("");
  const auto violations = [&](const MapBox& box) {
    return Validate(OctreeOptions{0.5, 1.0, box}, scene).violations().size();
  };
  EXPECT_EQ(violations({0.0, 0.0, 0.0, 1.0, 1.0, 1.0}), 0u);
  EXPECT_EQ(violations({nan, 0.0, 0.0, 1.0, 1.0, 1.0}), 1u);
  EXPECT_EQ(violations({0.0, 0.0, 0.0, -1.0, 1.0, HUGE_VAL}), 2u);
  EXPECT_EQ(violations({nan, nan, nan, nan, nan, nan}), 6u);
  EXPECT_EQ(violations({0.0, 0.0, 0.0, 0.0, 0.0, 0.0}), 0u);  // the voxel of a point
}

}  // namespace
}  // namespace latticeworld
