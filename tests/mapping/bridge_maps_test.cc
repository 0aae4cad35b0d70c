// The bridges of roads on occupancy grids and octomaps.

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <memory>

#include "hand_made_scene.h"
#include "latticeworld/mapping/octree.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/terrain/bridge.h"

namespace latticeworld {
namespace {

constexpr double kBed_m = -4.0;

// A gorge 12 m wide from north to south, and a bridge along x with a pier in its middle.
Scene Gorge() {
  Scene scene =
      MakeScene(128, 64.0, [](double x_m, double) { return std::abs(x_m) < 6.0 ? kBed_m : 0.0; });
  auto terrain = std::make_shared<Terrain>(*scene.terrain);
  Bridge bridge;
  bridge.line = {{-9.0, 0.0}, {9.0, 0.0}};
  bridge.width_m = 5.0;
  bridge.deck_z_m = 0.01;
  bridge.thickness_m = 0.4;
  bridge.water_level_m = kBed_m;
  bridge.load_kg = 1000.0;
  bridge.supports_m = {3.0, 9.0, 15.0};
  terrain->bridges = {bridge};
  scene.terrain = terrain;
  return scene;
}

std::int8_t At(const Scene& scene, const Grid<std::int8_t>& map, double x_m, double y_m) {
  return map[scene.geometry().CellAt({x_m, y_m})];
}

TEST(BridgeMapsTest, TheMapShowsTheDeckToWhomItCarries) {
  const Scene scene = Gorge();
  RobotLimits limits;
  limits.mass_kg = 50.0;
  const Grid<std::int8_t> map = BuildOccupancy(scene, limits);
  for (double x_m = -8.9; x_m < 9.0; x_m += 0.25) {
    EXPECT_EQ(At(scene, map, x_m, 0.2), 0) << x_m;
    // On land the deck's edge is a step of a centimetre.
    if (std::abs(x_m) > 5.0) continue;
    EXPECT_EQ(At(scene, map, x_m, 2.6), 100) << "beside the deck at " << x_m;
  }
}

TEST(BridgeMapsTest, WhomItDoesNotCarryGoesBelowAroundThePier) {
  const Scene scene = Gorge();
  RobotLimits limits;
  limits.mass_kg = 5000.0;
  const Grid<std::int8_t> map = BuildOccupancy(scene, limits);
  for (double y_m = -4.0; y_m < 4.0; y_m += 0.25) {
    EXPECT_EQ(At(scene, map, 3.2, y_m), 0) << y_m;
  }
  EXPECT_EQ(At(scene, map, 0.0, 0.2), 100) << "the pier";
}

TEST(BridgeMapsTest, BelowTheDeckTheOctomapIsFree) {
  const Scene scene = Gorge();
  OctreeOptions options;
  options.resolution_m = 0.25;
  const auto tree = BuildOctree(scene, options, Progress()).value();
  const auto occupied = [&](double x_m, double y_m, double z_m) {
    const octomap::OcTreeNode* node = tree->search(x_m, y_m, z_m);
    return node != nullptr && tree->isNodeOccupied(node);
  };
  EXPECT_TRUE(occupied(3.1, 0.1, -0.1)) << "the deck";
  for (double z_m = kBed_m + 0.6; z_m < -0.7; z_m += 0.25) {
    EXPECT_FALSE(occupied(3.1, 0.1, z_m)) << z_m;
    EXPECT_TRUE(occupied(0.1, 0.1, z_m)) << "the pier at " << z_m;
  }
  EXPECT_FALSE(occupied(3.1, 0.1, 0.6));
}

}  // namespace
}  // namespace latticeworld
