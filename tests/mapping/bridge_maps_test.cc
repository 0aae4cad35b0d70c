// The bridges of roads on occupancy grids and octomaps.

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <memory>
#include <vector>

#include "latticeworld/mapping/bridge_decks.h"
#include "latticeworld/mapping/octree/octree.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/scene/props/standing_props.h"
#include "latticeworld/terrain/ways/bridge.h"
#include "mapping/hand_made_scene.h"
#include "terrain/gorge_bridge.h"

namespace latticeworld {
namespace {

constexpr double kBed_m = -4.0;

// A gorge 12 m wide from north to south, and a bridge along x with a pier in its middle.
Scene Gorge(BridgeKind kind = BridgeKind::kGirder) {
  Scene scene =
      MakeScene(128, 64.0, [](double x_m, double) { return std::abs(x_m) < 6.0 ? kBed_m : 0.0; });
  auto terrain = std::make_shared<Terrain>(*scene.terrain);
  Bridge bridge = BridgeOverGorge(9.0, kBed_m, 1000.0);
  bridge.kind = kind;
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

// Two levels, one map: a ford 0.15 m deep below the deck.
TEST(BridgeMapsTest, TheFordBelowIsAWayToWhomTheDeckDoesNotCarryAndTheDeckToOthers) {
  const Scene scene = WithWater(Gorge(), static_cast<float>(kBed_m) + 0.15f);
  RobotLimits light, heavy, wading;
  light.mass_kg = 50.0;
  heavy.mass_kg = wading.mass_kg = 5000.0;
  wading.max_fording_depth_m = 0.1;
  const Grid<float> on_deck = BuildTraversability(scene, light);
  const Grid<float> below = BuildTraversability(scene, heavy);
  const Grid<std::int8_t> too_deep = BuildOccupancy(scene, wading);
  const CellIndex on = scene.geometry().CellAt({3.2, 0.2}), off = scene.geometry().CellAt({3.2, 5});
  EXPECT_EQ(on_deck[on], 1.0f) << "the deck is level open ground";
  EXPECT_LT(on_deck[off], 0.9f) << "the ford beside it";
  EXPECT_GT(on_deck[off], 0.0f);
  EXPECT_EQ(below[on], below[off]) << "the ford goes on below";
  EXPECT_EQ(too_deep[on], 100);
}

TEST(BridgeMapsTest, TheLayerOfDecksHasTheirTopsAndNothingBesideThem) {
  const Scene scene = Gorge();
  const Grid<float> deck_m = BuildDeckHeight(scene);
  const GridGeometry& geometry = scene.geometry();
  for (int row = 0; row < deck_m.rows(); ++row) {
    for (int col = 0; col < deck_m.cols(); ++col) {
      const WorldPoint at = geometry.CenterOf({row, col});
      const bool on = std::abs(at.x_m) <= 9.0 && std::abs(at.y_m) <= 2.5;
      ASSERT_EQ(std::isnan(deck_m(row, col)), !on) << at.x_m << ", " << at.y_m;
      if (on) ASSERT_FLOAT_EQ(deck_m(row, col), 0.01f);
    }
  }
}

TEST(BridgeMapsTest, ABrokenBridgeLeavesTheLayerOfDecks) {
  SceneChanges changes;
  changes.props = std::make_shared<const StandingProps>();
  for (const float deck_m : BuildDeckHeight(Gorge(), changes)) ASSERT_TRUE(std::isnan(deck_m));
}

TEST(BridgeMapsTest, OfTwoDecksTheHigherIsToldAbove) {
  const GridGeometry geometry = GridGeometry::FromCells(64, 64.0);
  std::vector<PropDeck> decks(2);
  decks[0].footprint = {{-31.0, 31.0}, 0.3, 4.0, 2.0};
  decks[0].top_m = 3.0;
  decks[1] = decks[0];
  decks[1].footprint.half_length_m = 1.0;
  decks[1].top_m = 7.0;
  const BridgeDecks index(geometry, decks);
  EXPECT_EQ(index.At({-31.0, 31.0}), &decks[1]);
  EXPECT_EQ(index.At({-28.5, 31.5}), &decks[0]);
  EXPECT_EQ(index.At({0.0, 0.0}), nullptr);
}

TEST(BridgeMapsTest, TheDrivenSurfaceIsTheDeckToWhomItCarries) {
  const Scene scene = Gorge();
  RobotLimits limits;
  limits.mass_kg = 50.0;
  for (double x_m = -8.9; x_m < 9.0; x_m += 0.25) {
    EXPECT_NEAR(DrivenSurface(scene, limits).HeightAt({x_m, 1.5}), 0.01, 0.011) << x_m;
  }
  limits.mass_kg = 5000.0;
  EXPECT_NEAR(DrivenSurface(scene, limits).HeightAt({3.2, 0.2}), kBed_m, 1e-6);
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
  EXPECT_TRUE(occupied(3.1, 2.4, 0.6)) << "the railing";
  for (double z_m = kBed_m + 0.6; z_m < -0.7; z_m += 0.25) {
    EXPECT_FALSE(occupied(3.1, 2.4, z_m)) << "below the railing at " << z_m;
  }
}

TEST(BridgeMapsTest, ArchesAreHighInTheirMiddleAndLowAtTheirPiers) {
  const Scene scene = Gorge(BridgeKind::kStoneArch);
  OctreeOptions options;
  options.resolution_m = 0.25;
  const auto tree = BuildOctree(scene, options, Progress()).value();
  const auto occupied = [&](double x_m, double z_m) {
    const octomap::OcTreeNode* node = tree->search(x_m, 0.1, z_m);
    return node != nullptr && tree->isNodeOccupied(node);
  };
  EXPECT_FALSE(occupied(3.1, -1.1)) << "below the crown";
  EXPECT_TRUE(occupied(0.6, -1.1)) << "beside the pier";
  EXPECT_FALSE(occupied(0.6, -3.6)) << "below the springing";
  RobotLimits limits;
  limits.mass_kg = 5000.0;
  const Grid<std::int8_t> map = BuildOccupancy(scene, limits);
  for (double y_m = -4.0; y_m < 4.0; y_m += 0.25) EXPECT_EQ(At(scene, map, 3.2, y_m), 0) << y_m;
}

}  // namespace
}  // namespace latticeworld
