#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/layout/claims/crossings.h"
#include "latticeworld/terrain/ways/bridge.h"
#include "terrain/terrain_building.h"

namespace latticeworld {
namespace {

constexpr int kSeeds = 200;
constexpr int kCells = 192;
constexpr double kSize_m = 192.0;

// Rivers from north to south and roads from west to east that wander by the seed, in steps that
// touch with corners too, lakes in every third layout, and roads that are wide or fork in others.
SymbolicLayout Wandering(std::uint64_t seed) {
  RandomStream random(seed, "bridges_test");
  SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kSuburb, 'G');
  if (seed % 3 == 0) {
    testing_layouts::PaintDisc('W', random.Uniform(8, 24), random.Uniform(8, 24),
                               random.Uniform(3, 7), &layout);
  }
  if (seed % 4 == 0) testing_layouts::PaintDisc('B', 16, 8, 3, &layout);
  const int width = random.UniformInt(1, 3);
  int col = random.UniformInt(8, 22);
  int west = kLayoutSize;
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int k = 0; k < width; ++k) layout.cells(row, col + k) = 'W';
    west = std::min(west, col);
    col = std::clamp(col + random.UniformInt(-1, 1), 2, kLayoutSize - 5);
  }
  const int road_width = seed % 5 == 0 ? random.UniformInt(2, 6) : 1;
  int row = random.UniformInt(8, 22);
  // On the land to the west of the river, no lake in its way.
  const int fork = seed % 7 == 0 && seed % 3 != 0 ? west - 3 : -1;
  for (int c = 0; c < kLayoutSize; ++c) {
    for (int k = 0; k < road_width; ++k) layout.cells(row + k, c) = 'R';
    if (c == fork) {
      for (int r = 0; r < row; ++r) layout.cells(r, c) = 'R';
    }
    // Wide roads turn in wide bends.
    if (c % road_width != 0) continue;
    row = std::clamp(row + random.UniformInt(-1, 1), 2, kLayoutSize - 3 - road_width);
  }
  return layout;
}

Terrain BuildWandering(int seed) {
  const SymbolicLayout layout = Wandering(seed);
  return Build(layout, GridGeometry::FromCells(kCells, kSize_m), seed);
}

bool IsOn(const BridgePart& part, WorldPoint point) {
  const double dx = point.x_m - part.middle.x_m, dy = point.y_m - part.middle.y_m;
  const double cosine = std::cos(part.yaw_rad), sine = std::sin(part.yaw_rad);
  return std::abs(cosine * dx + sine * dy) <= part.half_length_m &&
         std::abs(cosine * dy - sine * dx) <= part.half_width_m;
}

// 1 where the road runs, on land or on a bridge.
Grid<unsigned char> WayOf(const Terrain& terrain) {
  Grid<unsigned char> way(kCells, kCells, 0);
  for (int r = 0; r < kCells; ++r) {
    for (int c = 0; c < kCells; ++c) {
      way(r, c) = terrain.surface(r, c) == SurfaceClass::kRoad && !IsWet(terrain, r, c);
    }
  }
  for (const Bridge& bridge : terrain.bridges) {
    for (const BridgePart& part : PartsOf(bridge, terrain.ground)) {
      if (part.kind != BridgePartKind::kDeck) continue;
      for (int r = 0; r < kCells; ++r) {
        for (int c = 0; c < kCells; ++c) {
          if (IsOn(part, terrain.geometry().CenterOf({r, c}))) way(r, c) = 1;
        }
      }
    }
  }
  return way;
}

Grid<unsigned char> WaterOf(const Terrain& terrain) {
  Grid<unsigned char> water(kCells, kCells, 0);
  for (int r = 0; r < kCells; ++r) {
    for (int c = 0; c < kCells; ++c) water(r, c) = IsWet(terrain, r, c);
  }
  return water;
}

// Whether one piece of the mask, of cells with common sides, touches both edges.
bool Joins(const Grid<unsigned char>& mask, bool north_to_south) {
  Grid<unsigned char> seen(kCells, kCells, 0);
  std::vector<CellIndex> queue;
  for (int i = 0; i < kCells; ++i) {
    queue.push_back(north_to_south ? CellIndex{0, i} : CellIndex{i, 0});
  }
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const CellIndex cell = queue[next];
    if (!mask.Contains(cell) || seen[cell] || !mask[cell]) continue;
    seen[cell] = 1;
    if ((north_to_south ? cell.row : cell.col) == kCells - 1) return true;
    queue.push_back({cell.row - 1, cell.col});
    queue.push_back({cell.row + 1, cell.col});
    queue.push_back({cell.row, cell.col - 1});
    queue.push_back({cell.row, cell.col + 1});
  }
  return false;
}

// The share of a mask's cells that lie in its largest piece of cells with common sides; 1 where
// there are none.
double ShareInOnePiece(const Grid<unsigned char>& mask) {
  Grid<unsigned char> seen(kCells, kCells, 0);
  int all = 0, most = 0;
  for (int i = 0; i < kCells * kCells; ++i) {
    if (seen.data()[i] || !mask.data()[i]) continue;
    std::vector<CellIndex> piece = {{i / kCells, i % kCells}};
    seen.data()[i] = 1;
    for (std::size_t next = 0; next < piece.size(); ++next) {
      const CellIndex cell = piece[next];
      for (const CellIndex near : {CellIndex{cell.row - 1, cell.col},
                                   {cell.row + 1, cell.col},
                                   {cell.row, cell.col - 1},
                                   {cell.row, cell.col + 1}}) {
        if (!mask.Contains(near) || seen[near] || !mask[near]) continue;
        seen[near] = 1;
        piece.push_back(near);
      }
    }
    all += static_cast<int>(piece.size());
    most = std::max(most, static_cast<int>(piece.size()));
  }
  return all == 0 ? 1.0 : static_cast<double>(most) / all;
}

// The layout without its roads: what its waters are when nothing crosses them. Where the layout's
// water is one piece, roads included, so is that of the land.
bool WaterIsOnePiece(SymbolicLayout layout) {
  const Grid<Crossing> crossings = CrossingsOf(layout, false);
  const Grid<unsigned char> corners = CornerCrossingsOf(layout);
  Grid<unsigned char> seen(kLayoutSize, kLayoutSize, 0);
  const auto is_wet = [&](int r, int c) {
    return layout.cells(r, c) == 'W' || crossings(r, c) != Crossing::kNone;
  };
  int pieces = 0;
  for (int i = 0; i < kLayoutSize * kLayoutSize; ++i) {
    if (seen.data()[i] || !is_wet(i / kLayoutSize, i % kLayoutSize)) continue;
    ++pieces;
    std::vector<CellIndex> piece = {{i / kLayoutSize, i % kLayoutSize}};
    seen.data()[i] = 1;
    for (std::size_t next = 0; next < piece.size(); ++next) {
      for (int k = 0; k < 9; ++k) {
        const CellIndex near{piece[next].row + k / 3 - 1, piece[next].col + k % 3 - 1};
        if (!seen.Contains(near) || seen[near] || !is_wet(near.row, near.col)) continue;
        seen[near] = 1;
        piece.push_back(near);
      }
    }
  }
  return pieces == 1;
}

TEST(BridgesTest, EveryRiverIsOneWaterAndEveryRoadIsOneWay) {
  int whole = 0, wide = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const Terrain terrain = BuildWandering(seed);
    EXPECT_TRUE(Joins(WaterOf(terrain), true)) << "the river of seed " << seed;
    EXPECT_TRUE(Joins(WayOf(terrain), false)) << "the road of seed " << seed;
    EXPECT_FALSE(terrain.bridges.empty()) << "seed " << seed;
    wide += seed % 5 == 0;
    // Roads fray a little beside the water that they cross, and that does too.
    EXPECT_GT(ShareInOnePiece(WayOf(terrain)), 0.97) << "the road of seed " << seed;
    if (!WaterIsOnePiece(Wandering(seed))) continue;
    ++whole;
    EXPECT_GT(ShareInOnePiece(WaterOf(terrain)), 0.97) << "the water of seed " << seed;
  }
  EXPECT_GT(whole, kSeeds / 2);
  EXPECT_EQ(wide, kSeeds / 5);
}

TEST(BridgesTest, DecksClearTheWaterAndMeetTheLandAtTheirEnds) {
  for (int seed = 1; seed <= kSeeds; seed += 2) {
    const Terrain terrain = BuildWandering(seed);
    for (const Bridge& bridge : terrain.bridges) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", at " << bridge.line[0].x_m << ", "
                                      << bridge.line[0].y_m);
      EXPECT_GE(bridge.clearance_m(), 0.59);
      EXPECT_GT(bridge.load_kg, 1000.0);
      const double length_m = bridge.length_m();
      for (const double along_m : {0.0, length_m}) {
        const WorldPoint end = PlaceOn(bridge, along_m).point;
        const bool at_edge = std::max(std::abs(end.x_m), std::abs(end.y_m)) > 0.48 * kSize_m;
        if (at_edge) continue;
        EXPECT_EQ(terrain.WaterDepthAt(end), 0.0);
        EXPECT_NEAR(terrain.ground.HeightAt(end), bridge.deck_z_m, 0.15);
      }
      for (double along_m = 0.0; along_m < length_m; along_m += 0.5) {
        const WorldPoint point = PlaceOn(bridge, along_m).point;
        EXPECT_LE(terrain.ground.HeightAt(point), bridge.deck_z_m + 0.02);
        const float level_m = terrain.water_level_m[terrain.geometry().CellAt(point)];
        if (std::isnan(level_m)) continue;
        EXPECT_GT(bridge.deck_z_m - bridge.thickness_m - level_m, 0.55);
      }
    }
  }
}

TEST(BridgesTest, KindsFollowWidthAndSetting) {
  SymbolicLayout layout = testing_layouts::RiverAndRoad();
  const auto kind_of = [&](double size_m) {
    const Terrain terrain = Build(layout, GridGeometry::FromCells(256, size_m), 1);
    EXPECT_EQ(terrain.bridges.size(), 1u);
    return terrain.bridges.at(0).kind;
  };
  EXPECT_EQ(kind_of(150.0), BridgeKind::kPlank);
  EXPECT_EQ(kind_of(256.0), BridgeKind::kGirder);
  testing_layouts::PaintDisc('B', 16, 8, 3, &layout);
  EXPECT_EQ(kind_of(256.0), BridgeKind::kStoneArch);
}

TEST(BridgesTest, DecksAreAsWideAsTheirRoadsButNoWiderThanTwoLanes) {
  constexpr double kCell_m = 3.0;  // of the layout
  for (int width = 1; width <= 5; ++width) {
    SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kSuburb, 'G');
    for (int row = 0; row < kLayoutSize; ++row) layout.cells(row, 12) = layout.cells(row, 13) = 'W';
    for (int row = 14; row < 14 + width; ++row) {
      for (int col = 0; col < kLayoutSize; ++col) layout.cells(row, col) = 'R';
    }
    TerrainRequest request;
    request.geometry = GridGeometry::FromCells(kCells, kLayoutSize * kCell_m);
    request.layout = &layout;
    request.seed = 3;
    const Terrain terrain = BuildTerrain(request, Progress()).value();
    ASSERT_EQ(terrain.bridges.size(), 1u) << width;
    EXPECT_NEAR(terrain.bridges[0].width_m, std::min(0.92 * width * kCell_m, 10.0), 1e-9) << width;
    EXPECT_TRUE(Joins(WaterOf(terrain), true)) << width;
  }
}

TEST(BridgesTest, ShallowRiversAreForded) {
  const Terrain terrain =
      Build(testing_layouts::RiverAndRoad(), GridGeometry::FromCells(128, 100.0), 1);
  EXPECT_TRUE(terrain.bridges.empty());
}

TEST(BridgesTest, PartsAreDeckRailingsAndPiersDownToTheBed) {
  Bridge bridge;
  bridge.line = {{-30.0, 0.0}, {30.0, 0.0}};
  bridge.width_m = 6.0;
  bridge.deck_z_m = 5.0;
  bridge.thickness_m = 0.5;
  bridge.railing_m = 1.0;
  bridge.supports_m = {5.0, 30.0, 55.0};
  const HeightField ground(GridGeometry::FromCells(64, 64.0), Grid<float>(64, 64, -2.0f));
  int decks = 0, railings = 0, piers = 0;
  double deck_m = 0.0;
  for (const BridgePart& part : PartsOf(bridge, ground)) {
    EXPECT_LE(2.0 * part.half_length_m, kLongestBridgePart_m);
    switch (part.kind) {
      case BridgePartKind::kDeck:
        ++decks;
        deck_m += 2.0 * part.half_length_m;
        EXPECT_EQ(part.top_m, 5.0);
        EXPECT_EQ(part.bottom_m, 4.5);
        break;
      case BridgePartKind::kRailing:
        ++railings;
        EXPECT_EQ(part.top_m, 6.0);
        EXPECT_GT(std::abs(part.middle.y_m), 2.5);
        break;
      case BridgePartKind::kPier:
        ++piers;
        EXPECT_NEAR(part.middle.x_m, 0.0, 1e-9);
        EXPECT_EQ(part.top_m, 4.5);
        EXPECT_LT(part.bottom_m, -2.0);
        break;
      case BridgePartKind::kArch:
        ADD_FAILURE() << "a girder bridge has no arches";
    }
  }
  EXPECT_EQ(decks, 2);
  EXPECT_EQ(railings, 4);
  EXPECT_EQ(piers, 1);
  EXPECT_NEAR(deck_m, 60.0, 1e-9);
}

TEST(BridgesTest, TimberRailingsAreBeamsAndPostsWithoutAGapForWheels) {
  Bridge bridge;
  bridge.kind = BridgeKind::kPlank;
  bridge.line = {{-6.0, 0.0}, {6.0, 0.0}};
  bridge.width_m = 4.0;
  bridge.deck_z_m = 2.0;
  bridge.thickness_m = 0.2;
  bridge.railing_m = 1.0;
  bridge.supports_m = {2.0, 10.0};
  const HeightField ground(GridGeometry::FromCells(64, 64.0), Grid<float>(64, 64, -2.0f));
  const std::vector<BridgePart> parts = PartsOf(bridge, ground);
  int posts = 0;
  for (double x_m = -4.9; x_m < 4.95; x_m += 0.1) {
    double covered_m = 0.0;
    bool kerb = false, top = false;
    for (const BridgePart& part : parts) {
      if (part.kind != BridgePartKind::kRailing || !IsOn(part, {x_m, 1.9})) continue;
      EXPECT_GE(part.bottom_m, 2.0);
      EXPECT_LE(part.top_m, 3.0);
      kerb = kerb || (part.bottom_m == 2.0 && part.top_m >= 2.2);
      top = top || part.top_m == 3.0;
      covered_m = std::max(covered_m, part.top_m - part.bottom_m);
    }
    EXPECT_TRUE(kerb && top) << x_m;
    posts += covered_m > 0.9;
  }
  EXPECT_GT(posts, 5);
  EXPECT_LT(posts, 30) << "between the posts it is open";
}

TEST(BridgesTest, RailingsOfABendMeetAndLeaveTheDeckFree) {
  Bridge bridge;
  bridge.line = {{-20.0, 0.0}, {0.0, 0.0}, {15.0, 15.0}};
  bridge.width_m = 6.0;
  bridge.deck_z_m = 5.0;
  bridge.thickness_m = 0.5;
  bridge.railing_m = 1.0;
  bridge.supports_m = {5.0, 35.0};
  const HeightField ground(GridGeometry::FromCells(64, 64.0), Grid<float>(64, 64, -2.0f));
  const std::vector<BridgePart> parts = PartsOf(bridge, ground);
  for (double along_m = 0.0; along_m <= bridge.length_m(); along_m += 0.25) {
    const BridgePlace place = PlaceOn(bridge, along_m);
    bool on_deck = false;
    for (const BridgePart& part : parts) {
      const bool on = IsOn(part, place.point);
      on_deck = on_deck || (on && part.kind == BridgePartKind::kDeck);
      EXPECT_FALSE(on && part.kind == BridgePartKind::kRailing) << along_m;
    }
    EXPECT_TRUE(on_deck) << along_m;
  }
}

}  // namespace
}  // namespace latticeworld
