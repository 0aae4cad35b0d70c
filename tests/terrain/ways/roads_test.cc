#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/scene/footprint.h"
#include "latticeworld/scene/props/standing_props.h"
#include "latticeworld/scene/scene.h"
#include "terrain/terrain_building.h"

namespace latticeworld {
namespace {

constexpr int kSeeds = 20;
constexpr int kCells = 512;
constexpr double kSize_m = 512.0;

// A road that winds from west to east over a river from north to south.
SymbolicLayout Crossing(int river_cells) {
  SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kSuburb, 'G');
  for (int r = 0; r < kLayoutSize; ++r) {
    const int c = 15 + static_cast<int>(std::lround(2.0 * std::sin(r / 4.0)));
    for (int k = 0; k < river_cells; ++k) layout.cells(r, c + k) = 'W';
  }
  for (int c = 0; c < kLayoutSize; ++c) {
    layout.cells(16 + static_cast<int>(std::lround(3.0 * std::cos(c / 4.0))), c) = 'R';
  }
  return layout;
}

Grid<unsigned char> RoadCells(const Terrain& terrain) {
  Grid<unsigned char> road(kCells, kCells);
  for (std::size_t i = 0; i < road.size(); ++i) {
    road.data()[i] = terrain.surface.data()[i] == SurfaceClass::kRoad;
  }
  return road;
}

TEST(RoadsTest, KeepToTheirSlopeInSteepHills) {
  const Relief relief = Hills();
  for (int seed = 1; seed <= kSeeds; ++seed) {
    // Through the hills without a river, whose own fall a ford would have.
    const bool given = seed % 2 == 0;
    const Terrain terrain = Build(Crossing(given ? 0 : 1), GridGeometry::FromCells(kCells, kSize_m),
                                  seed, given ? &relief : nullptr);
    const Grid<float> to_verge = DistanceTo(false, RoadCells(terrain));
    const Grid<float> slope = GradientMagnitude(terrain.ground.height_m(), 1.0);
    std::vector<double> slopes;
    for (std::size_t i = 0; i < slope.size(); ++i) {
      // The carriageway without its verges. In any direction, so along it as well.
      if (to_verge.data()[i] > 3.0f && std::isnan(terrain.water_level_m.data()[i])) {
        slopes.push_back(slope.data()[i]);
      }
    }
    ASSERT_GT(slopes.size(), 2000u);
    std::sort(slopes.begin(), slopes.end());
    EXPECT_LT(At(slopes, 0.99), 0.125) << "seed " << seed;
    EXPECT_LT(At(slopes, 1.0), 0.20) << "seed " << seed;
  }
}

TEST(RoadsTest, AGentlerLimitMakesGentlerRoads) {
  const Relief relief = Hills();
  const SymbolicLayout layout = Crossing(1);
  TerrainRequest request;
  request.geometry = GridGeometry::FromCells(kCells, kSize_m);
  request.layout = &layout;
  request.relief = &relief;
  request.seed = 3;
  request.options.max_road_slope = 0.05;
  const Terrain terrain = BuildTerrain(request, Progress()).value();
  EXPECT_LT(std::tan(At(SlopesOfClass_deg(terrain, SurfaceClass::kRoad), 0.9) * M_PI / 180.0),
            0.055);
}

// How many cells at the east edge can be reached from the road at the west edge over free road and
// bridges.
int ReachedAtTheOtherEnd(const Terrain& terrain) {
  Scene scene;
  scene.terrain = std::make_shared<const Terrain>(terrain);
  const Grid<std::int8_t> occupancy = BuildOccupancy(scene, RobotLimits());
  Grid<unsigned char> way = RoadCells(terrain);
  const StandingProps standing = StandingAtBegin(scene);
  for (int r = 0; r < kCells; ++r) {
    for (int c = 0; c < kCells; ++c) {
      for (const PropDeck& deck : standing.decks) {
        if (GapTo(deck.footprint, terrain.geometry().CenterOf({r, c})) <= 0.0) way(r, c) = 1;
      }
    }
  }
  Grid<unsigned char> reached(kCells, kCells, 0);
  std::vector<CellIndex> queue;
  for (int r = 0; r < kCells; ++r) queue.push_back({r, 0});
  int at_the_other_end = 0;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const CellIndex cell = queue[next];
    if (!reached.Contains(cell) || reached[cell] || !way[cell] || occupancy[cell] >= 50) continue;
    reached[cell] = 1;
    at_the_other_end += cell.col == kCells - 1;
    for (const CellIndex near :
         {CellIndex{cell.row - 1, cell.col}, CellIndex{cell.row + 1, cell.col},
          CellIndex{cell.row, cell.col - 1}, CellIndex{cell.row, cell.col + 1}}) {
      queue.push_back(near);
    }
  }
  return at_the_other_end;
}

Terrain BuildWithFords(const SymbolicLayout& layout, int seed, const Relief* relief) {
  TerrainRequest request;
  request.geometry = GridGeometry::FromCells(kCells, kSize_m);
  request.layout = &layout;
  request.relief = relief;
  request.seed = seed;
  request.options.fords = true;
  return BuildTerrain(request, Progress()).value();
}

TEST(RoadsTest, ARiverIsFordedWhereTheOptionsSaySo) {
  const Relief relief = Valley();
  for (int seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const bool given = seed % 4 == 0;
    const Terrain terrain = BuildWithFords(Crossing(1 + seed % 2), seed, given ? &relief : nullptr);
    EXPECT_TRUE(terrain.bridges.empty());
    int ford = 0;
    double deepest_m = 0.0;
    for (int r = 0; r < kCells; ++r) {
      bool wet = false;
      for (int c = 0; c < kCells; ++c) {
        if (!IsWet(terrain, r, c)) continue;
        wet = true;
        if (terrain.surface(r, c) != SurfaceClass::kRoad) continue;
        ++ford;
        deepest_m = std::max<double>(deepest_m,
                                     terrain.water_level_m(r, c) - terrain.ground.height_m()(r, c));
      }
      EXPECT_TRUE(wet) << "the road cuts the river in row " << r;
    }
    EXPECT_GT(ford, 60);
    EXPECT_GT(deepest_m, 0.05);
    EXPECT_LE(deepest_m, 0.151);
    // The robot that maps are made for drives through.
    EXPECT_GT(ReachedAtTheOtherEnd(terrain), 5);
  }
}

TEST(RoadsTest, ARiverIsBridgedAndTheRobotDrivesOver) {
  const Relief relief = Valley();
  for (int seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const bool given = seed % 4 == 0;
    const Terrain terrain = Build(Crossing(1 + seed % 3), GridGeometry::FromCells(kCells, kSize_m),
                                  seed, given ? &relief : nullptr);
    EXPECT_EQ(terrain.bridges.size(), 1u);
    EXPECT_GT(ReachedAtTheOtherEnd(terrain), 5);
  }
}

TEST(RoadsTest, AWideLakeIsBridgedAndStaysOneLake) {
  SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kSuburb, 'G');
  testing_layouts::PaintDisc('W', 16, 16, 7.5, &layout);
  for (int c = 0; c < kLayoutSize; ++c) layout.cells(16, c) = 'R';
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const Terrain terrain = Build(layout, GridGeometry::FromCells(kCells, kSize_m), seed);
    for (int r = 13 * 16; r < 20 * 16; ++r) {
      ASSERT_TRUE(IsWet(terrain, r, 256)) << "seed " << seed << ", row " << r;
      EXPECT_EQ(terrain.water_level_m(r, 256), terrain.water_level_m(13 * 16, 256));
    }
    EXPECT_GT(ReachedAtTheOtherEnd(terrain), 5) << "seed " << seed;
  }
}

}  // namespace
}  // namespace latticeworld
