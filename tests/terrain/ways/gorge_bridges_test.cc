#include "latticeworld/terrain/ways/gorge_bridges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latticeworld/terrain/forms/relief_measures.h"
#include "terrain/terrain_building.h"

namespace latticeworld {
namespace {

using internal::ReliefPiece;
using testing_layouts::Filled;

constexpr int kSeeds = 12;

ReliefWish Gorge(const char* from, const char* to) {
  ReliefWish wish;
  wish.kind = ReliefKind::kGorge;
  wish.from = {*FindZone(from)};
  wish.to = {*FindZone(to)};
  wish.words = "gorge";
  return wish;
}

Terrain BuildOver(const ReliefWish& wish, const SymbolicLayout& layout, std::uint64_t seed,
                  std::optional<BridgeKind> kind = std::nullopt) {
  TerrainRequest request;
  request.geometry = GridGeometry::FromCells(256, 256.0);
  request.layout = &layout;
  request.reliefs = {wish};
  request.seed = seed;
  request.options.bridge_kind = kind;
  return BuildTerrain(request, Progress()).value();
}

SymbolicLayout WithRoad() {
  SymbolicLayout layout = Filled(Vocabulary::kSuburb, 'G');
  for (int c = 0; c < kLayoutSize; ++c) layout.cells(15, c) = 'R';
  return layout;
}

// A road that the layout draws over a gorge needs no word for its bridge.
TEST(GorgeBridgesTest, EveryRoadOverAGorgeHasABridgeLevelFromRimToRim) {
  const SymbolicLayout layout = WithRoad();
  const ReliefWish wish = Gorge("northern edge", "southern edge");
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Terrain terrain = BuildOver(wish, layout, seed);
    ASSERT_EQ(terrain.bridges.size(), 1u) << seed;
    const Bridge& bridge = terrain.bridges.front();
    EXPECT_GT(bridge.clearance_m(), 4.0) << seed;
    EXPECT_GT(bridge.railing_m, 0.0) << seed;
    // Its ends lie on ground as high as the deck, and road leads on from there.
    for (const WorldPoint end : {bridge.line.front(), bridge.line.back()}) {
      EXPECT_NEAR(terrain.ground.HeightAt(end), bridge.deck_z_m, 0.6) << seed;
      EXPECT_EQ(terrain.SurfaceAt(end), SurfaceClass::kRoad) << seed;
    }
    // Below it there is neither road nor dam.
    const ReliefPiece piece = internal::PlaceReliefs({wish}, layout, 256.0).front();
    double lowest_m = bridge.deck_z_m;
    for (double along_m = bridge.supports_m.front() + 2.0; along_m < bridge.supports_m.back() - 2.0;
         along_m += 0.5) {
      const WorldPoint at = PlaceOn(bridge, along_m).point;
      EXPECT_NE(terrain.SurfaceAt(at), SurfaceClass::kRoad) << seed;
      lowest_m = std::min(lowest_m, terrain.ground.HeightAt(at));
    }
    EXPECT_LT(lowest_m, bridge.deck_z_m - 0.5 * piece.height_m) << seed;
  }
}

// As high below the bridge as a little before and behind it: who walks in the gorge passes.
TEST(GorgeBridgesTest, TheFloorOfAGorgeRunsOnBelowItsBridge) {
  const ReliefWish wish = Gorge("northern edge", "southern edge");
  const SymbolicLayout layout = WithRoad();
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Terrain terrain = BuildOver(wish, layout, seed);
    ASSERT_FALSE(terrain.bridges.empty()) << seed;
    const ReliefPiece piece = internal::PlaceReliefs({wish}, layout, 256.0).front();
    const Bridge& bridge = terrain.bridges.front();
    const WorldPoint middle = PlaceOn(bridge, 0.5 * bridge.length_m()).point;
    const auto floor_m = [&](double offset_m) {
      double least_m = 1e9;
      for (double x_m = middle.x_m - 20.0; x_m <= middle.x_m + 20.0; x_m += 0.5) {
        least_m = std::min(least_m, terrain.ground.HeightAt({x_m, middle.y_m + offset_m}));
      }
      return least_m;
    };
    for (double offset_m = -20.0; offset_m <= 20.0; offset_m += 1.0) {
      EXPECT_LT(floor_m(offset_m), floor_m(20.0) + 0.2 * piece.height_m) << seed << " " << offset_m;
    }
  }
}

TEST(GorgeBridgesTest, ABridgeOverAGorgeIsOfTheKindThatIsAskedFor) {
  const ReliefWish wish = Gorge("northern edge", "southern edge");
  for (const auto& [kind, name] : EnumNames(BridgeKind{})) {
    const Terrain terrain = BuildOver(wish, WithRoad(), 3, kind);
    ASSERT_EQ(terrain.bridges.size(), 1u) << name;
    const Bridge& bridge = terrain.bridges.front();
    EXPECT_EQ(bridge.kind, kind) << name;
    for (const BridgePart& part : PartsOf(bridge, terrain.ground)) {
      EXPECT_LT(part.bottom_m, part.top_m) << name;
      EXPECT_TRUE(terrain.geometry().Contains(part.middle)) << name;
    }
  }
}

TEST(GorgeBridgesTest, ARoadBesideAGorgeIsNoRoadOverIt) {
  SymbolicLayout layout = Filled(Vocabulary::kSuburb, 'G');
  for (int r = 0; r < kLayoutSize; ++r) layout.cells(r, 4) = 'R';
  const ReliefWish wish = Gorge("northern edge", "southern edge");
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    EXPECT_TRUE(BuildOver(wish, layout, seed).bridges.empty()) << seed;
  }
}

// Where nothing is said of a bridge and no road crosses, the land is what it was.
TEST(GorgeBridgesTest, WildLandWithAGorgeHasNoWay) {
  const SymbolicLayout layout = Filled(Vocabulary::kWild, 'B');
  ReliefWish wish = Gorge("northern edge", "southern edge");
  const auto roads = [](const Terrain& terrain) {
    return std::count(terrain.surface.begin(), terrain.surface.end(), SurfaceClass::kRoad);
  };
  EXPECT_EQ(roads(BuildOver(wish, layout, 2)), 0);
  ReliefTie bridged;
  bridged.kind = ReliefTie::Kind::kBridged;
  bridged.letter = '\0';
  wish.ties = {bridged};
  const Terrain terrain = BuildOver(wish, layout, 2);
  EXPECT_EQ(terrain.bridges.size(), 1u);
  EXPECT_GT(roads(terrain), 200);
}

}  // namespace
}  // namespace latticeworld
