#include "latticeworld/terrain/ways/streets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/terrain/components.h"
#include "latticeworld/terrain/cover.h"
#include "terrain/terrain_building.h"

namespace latticeworld {
namespace {

constexpr int kSeeds = 20;
constexpr int kCells = 256;
constexpr int kFineCells = 512;
constexpr double kSize_m = 512.0;

Grid<unsigned char> RoadCells(const Terrain& terrain) {
  Grid<unsigned char> road(terrain.surface.rows(), terrain.surface.cols());
  for (std::size_t i = 0; i < road.size(); ++i) {
    road.data()[i] = terrain.surface.data()[i] == SurfaceClass::kRoad;
  }
  return road;
}

// Paved, and none of the layout's roads.
Grid<unsigned char> StreetCells(const Terrain& terrain) {
  Grid<unsigned char> street = RoadCells(terrain);
  const WeightGrid* roads = terrain.weights.Find('R');
  for (int r = 0; r < street.rows() && roads != nullptr; ++r) {
    for (int c = 0; c < street.cols(); ++c) {
      if (terrain.weights.DominantAt({r, c}) == 'R') street(r, c) = 0;
    }
  }
  return street;
}

int CountOf(const Grid<unsigned char>& mask) {
  return static_cast<int>(std::count(mask.begin(), mask.end(), 1));
}

// A winding road with side roads, by the seed, over a river; a town, villages and farmland.
SymbolicLayout Country(std::uint64_t seed) {
  RandomStream random(seed, "streets_test");
  SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kSuburb, 'G');
  testing_layouts::PaintDisc('A', random.Uniform(0, 31), random.Uniform(0, 31), 6.0, &layout);
  testing_layouts::PaintDisc('F', random.Uniform(0, 31), random.Uniform(0, 31), 5.0, &layout);
  testing_layouts::PaintDisc('B', random.Uniform(8, 24), random.Uniform(8, 24), 6.0, &layout);
  for (int i = 0; i < 3; ++i) {
    testing_layouts::PaintDisc('B', random.Uniform(3, 28), random.Uniform(3, 28),
                               random.Uniform(1.5, 3.0), &layout);
  }
  const double swing = random.Uniform(1.0, 5.0), phase = random.Uniform(0.0, 6.0);
  for (int r = 0; r < kLayoutSize; ++r) {
    layout.cells(r, 22 + static_cast<int>(std::lround(swing * std::sin(r / 5.0 + phase)))) = 'W';
  }
  const int row = random.UniformInt(8, 23);
  int last = row;
  for (int c = 0; c < kLayoutSize; ++c) {
    const int r = row + static_cast<int>(std::lround(swing * std::sin(c / 6.0 + phase)));
    for (int k = std::min(r, last); k <= std::max(r, last); ++k) {
      layout.cells(std::clamp(k, 0, kLayoutSize - 1), c) = 'R';
    }
    last = r;
  }
  // A side road from the edge of the world to the main one.
  const int column = random.UniformInt(4, 14);
  for (int r = 0; r < kLayoutSize && layout.cells(r, column) != 'R'; ++r) {
    layout.cells(r, column) = 'R';
  }
  return layout;
}

// The countries of every seed, built once.
class StreetsOfCountriesTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    countries_ = new std::vector<Terrain>();
    for (int seed = 1; seed <= kSeeds; ++seed) {
      countries_->push_back(
          Build(Country(seed), GridGeometry::FromCells(kFineCells, kSize_m), seed));
    }
  }
  static void TearDownTestSuite() {
    delete countries_;
    countries_ = nullptr;
  }
  static const Terrain& CountryOf(int seed) { return (*countries_)[seed - 1]; }

 private:
  static std::vector<Terrain>* countries_;
};
std::vector<Terrain>* StreetsOfCountriesTest::countries_ = nullptr;

// The paved cell at or next to the middle of a layout cell, {-1, -1}: none.
CellIndex PavedNear(const Grid<unsigned char>& road, int row, int col) {
  const double scale = static_cast<double>(road.rows()) / kLayoutSize;
  const int r = static_cast<int>((row + 0.5) * scale), c = static_cast<int>((col + 0.5) * scale);
  CellIndex best{-1, -1};
  double least = 0.75 * scale;
  for (int i = r - 12; i <= r + 12; ++i) {
    for (int k = c - 12; k <= c + 12; ++k) {
      if (!road.Contains({i, k}) || road(i, k) == 0 || std::hypot(i - r, k - c) >= least) continue;
      least = std::hypot(i - r, k - c);
      best = {i, k};
    }
  }
  return best;
}

TEST_F(StreetsOfCountriesTest, RoadsAreConnectedAsTheLayoutConnectsThem) {
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const SymbolicLayout layout = Country(seed);
    SCOPED_TRACE(testing::Message() << "seed " << seed << "\n" << ToText(layout));
    const Terrain& terrain = CountryOf(seed);
    Grid<unsigned char> road = RoadCells(terrain);
    const Grid<unsigned char> deck = AtDecks(terrain, terrain.geometry().resolution_m());
    for (std::size_t i = 0; i < road.size(); ++i) {
      if (deck.data()[i] != 0) road.data()[i] = 1;
    }
    const internal::Components pieces = internal::ComponentsOf(road);
    for (int r = 0; r < kLayoutSize; ++r) {
      for (int c = 0; c < kLayoutSize; ++c) {
        if (layout.cells(r, c) != 'R') continue;
        const CellIndex here = PavedNear(road, r, c);
        ASSERT_GE(here.row, 0) << "no road at the layout's row " << r << " column " << c;
        internal::ForEachNeighbour(layout.cells, r, c, [&](int i, int k) {
          if (layout.cells(i, k) != 'R') return;
          const CellIndex there = PavedNear(road, i, k);
          if (there.row < 0) return;  // said above
          EXPECT_EQ(pieces.label[here], pieces.label[there])
              << "(" << r << ", " << c << ") and (" << i << ", " << k << ")";
        });
        // Up to the border of the world.
        if (c == 0 || c == kLayoutSize - 1) {
          const int edge = c == 0 ? 0 : kFineCells - 1;
          bool reaches = false;
          for (int i = -12; i <= 12; ++i) {
            const int at = std::clamp(here.row + i, 0, kFineCells - 1);
            reaches = reaches || road(at, edge) != 0;
          }
          EXPECT_TRUE(reaches) << "a gap at the border, row " << r;
        }
      }
    }
  }
}

TEST_F(StreetsOfCountriesTest, RoadsAndStreetsHaveTheirWidth) {
  // Of everything that is paved, seen from its middle: the layout's roads are as wide as a cell of
  // it, streets much narrower.
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const Terrain& terrain = CountryOf(seed);
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Grid<unsigned char> streets = StreetCells(terrain);
    const Grid<float> to_edge = DistanceTo(false, RoadCells(terrain));
    double widest_street_m = 0.0, widest_road_m = 0.0;
    for (std::size_t i = 0; i < streets.size(); ++i) {
      double& widest_m = streets.data()[i] != 0 ? widest_street_m : widest_road_m;
      widest_m = std::max(widest_m, 2.0 * to_edge.data()[i] - 1.0);
    }
    // Crossings at flat angles and of several roads are wider than what meets there.
    EXPECT_LT(widest_street_m, 14.0);
    EXPECT_GT(widest_road_m, 12.0);
    EXPECT_LT(widest_road_m, 45.0);
    // Most of a street is as wide as it should be: 4 to 5 m, and a cell more or less.
    std::vector<double> widths_m;
    for (int r = 1; r + 1 < streets.rows(); ++r) {
      for (int c = 1; c + 1 < streets.cols(); ++c) {
        if (streets(r, c) == 0) continue;
        bool ridge = true;
        internal::ForEachNeighbour(
            to_edge, r, c, [&](int i, int k) { ridge = ridge && to_edge(i, k) <= to_edge(r, c); });
        if (ridge) widths_m.push_back(2.0 * to_edge(r, c) - 1.0);
      }
    }
    if (widths_m.empty()) continue;
    std::sort(widths_m.begin(), widths_m.end());
    EXPECT_GE(At(widths_m, 0.5), 3.0);
    EXPECT_LE(At(widths_m, 0.5), 6.0);
  }
}

TEST_F(StreetsOfCountriesTest, RunInBuiltUpLandOrFromItToARoadAndNeverInWater) {
  int with_streets = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const Terrain& terrain = CountryOf(seed);
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Grid<unsigned char> streets = StreetCells(terrain);
    with_streets += CountOf(streets) > 200;
    const double cell_m = terrain.geometry().resolution_m();
    Grid<unsigned char> built(kFineCells, kFineCells), wet(kFineCells, kFineCells);
    for (int r = 0; r < kFineCells; ++r) {
      for (int c = 0; c < kFineCells; ++c) {
        built(r, c) = terrain.weights.DominantAt({r, c}) == 'B';
        wet(r, c) = IsWet(terrain, r, c);
      }
    }
    const Grid<float> to_built = DistanceTo(true, built), to_water = DistanceTo(true, wet);
    for (std::size_t i = 0; i < streets.size(); ++i) {
      if (streets.data()[i] == 0) continue;
      ASSERT_GT(to_water.data()[i] * cell_m, 3.0);
      ASSERT_LT(to_built.data()[i] * cell_m, internal::StreetRule().road_reach_m + 10.0);
    }
  }
  EXPECT_GE(with_streets, kSeeds - 2);
}

TEST(StreetsTest, AllStreetsOfAnAreaHangTogetherAndWithItsRoad) {
  for (int seed = 1; seed <= kSeeds; ++seed) {
    SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kSuburb, 'G');
    RandomStream random(seed, "streets_test/one");
    const double row = random.Uniform(10, 20);
    testing_layouts::PaintDisc('B', row, random.Uniform(12, 20), random.Uniform(2.5, 8.0), &layout);
    // Through it, beside it or a little away from it.
    const int road = static_cast<int>(row) + random.UniformInt(-9, 0);
    for (int c = 0; c < kLayoutSize; ++c) layout.cells(std::max(road, 0), c) = 'R';
    SCOPED_TRACE(testing::Message() << "seed " << seed << "\n" << ToText(layout));
    const Terrain terrain = Build(layout, GridGeometry::FromCells(kCells, kSize_m), seed);
    const internal::Components pieces = internal::ComponentsOf(RoadCells(terrain));
    const Grid<float> to_road = DistanceTo(true, internal::MaskOf('R', [&] {
                                             Grid<char> letters(kCells, kCells);
                                             for (int r = 0; r < kCells; ++r) {
                                               for (int c = 0; c < kCells; ++c) {
                                                 letters(r, c) = terrain.weights.DominantAt({r, c});
                                               }
                                             }
                                             return letters;
                                           }()));
    double gap_m = 1e9;
    for (int r = 0; r < kCells; ++r) {
      for (int c = 0; c < kCells; ++c) {
        if (terrain.weights.DominantAt({r, c}) == 'B') {
          gap_m = std::min<double>(gap_m, to_road(r, c) * terrain.geometry().resolution_m());
        }
      }
    }
    // One piece with the road where that is within reach, else two.
    if (gap_m < internal::StreetRule().road_reach_m - 6.0) {
      EXPECT_EQ(pieces.count(), 1) << gap_m << " m";
    } else {
      EXPECT_LE(pieces.count(), 2) << gap_m << " m";
    }
  }
}

TEST(StreetsTest, EveryPlaceOfATownIsNearAStreet) {
  for (int seed = 1; seed <= kSeeds / 2; ++seed) {
    SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kSuburb, 'G');
    RandomStream random(seed, "streets_test/town");
    for (int i = 0; i < 4; ++i) {
      testing_layouts::PaintDisc('B', random.Uniform(12, 20), random.Uniform(10, 22),
                                 random.Uniform(3.0, 6.0), &layout);
    }
    const Terrain terrain = Build(layout, GridGeometry::FromCells(kCells, 2.0 * kSize_m), seed);
    const Grid<float> to_street = DistanceTo(true, RoadCells(terrain));
    std::vector<double> distances_m;
    for (int r = 0; r < kCells; ++r) {
      for (int c = 0; c < kCells; ++c) {
        if (terrain.weights.DominantAt({r, c}) != 'B') continue;
        distances_m.push_back(to_street(r, c) * terrain.geometry().resolution_m());
      }
    }
    std::sort(distances_m.begin(), distances_m.end());
    ASSERT_GT(distances_m.size(), 1000u);
    EXPECT_LT(At(distances_m, 0.5), 30.0) << "seed " << seed;
    EXPECT_LT(At(distances_m, 0.95), 65.0) << "seed " << seed;
    // Blocks, not one paved yard.
    EXPECT_GT(At(distances_m, 0.5), 6.0) << "seed " << seed;
  }
}

TEST(StreetsTest, KeepToTheSlopeOfRoads) {
  const Relief relief = Hills();
  SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kSuburb, 'G');
  testing_layouts::PaintDisc('B', 16, 16, 9.0, &layout);
  for (int seed = 1; seed <= 5; ++seed) {
    const Terrain terrain = Build(layout, GridGeometry::FromCells(512, kSize_m), seed, &relief);
    const Grid<float> to_verge = DistanceTo(false, RoadCells(terrain));
    const Grid<float> slope = GradientMagnitude(terrain.ground.height_m(), 1.0);
    std::vector<double> slopes;
    for (std::size_t i = 0; i < slope.size(); ++i) {
      if (to_verge.data()[i] > 1.5f) slopes.push_back(slope.data()[i]);
    }
    ASSERT_GT(slopes.size(), 1000u);
    std::sort(slopes.begin(), slopes.end());
    EXPECT_LT(At(slopes, 0.95), 0.16) << "seed " << seed;
  }
}

TEST(StreetsTest, AreTheSameForTheSameSeedAndAtOtherResolutions) {
  const SymbolicLayout layout = Country(3);
  const Terrain a = Build(layout, GridGeometry::FromCells(kCells, kSize_m), 3);
  EXPECT_EQ(a.surface, Build(layout, GridGeometry::FromCells(kCells, kSize_m), 3).surface);
  EXPECT_NE(a.surface, Build(layout, GridGeometry::FromCells(kCells, kSize_m), 4).surface);
  const Terrain fine = Build(layout, GridGeometry::FromCells(3 * kCells, kSize_m), 3);
  const Grid<float> to_fine = DistanceTo(true, StreetCells(fine));
  const Grid<unsigned char> coarse = StreetCells(a);
  int far = 0;
  for (int r = 0; r < kCells; ++r) {
    for (int c = 0; c < kCells; ++c) far += coarse(r, c) != 0 && to_fine(3 * r + 1, 3 * c + 1) > 6;
  }
  EXPECT_LT(far, 0.03 * CountOf(coarse) + 5);
}

TEST(StreetsTest, LeaveWeightsAndCoarseWorldsAlone) {
  const SymbolicLayout layout = Country(5);
  const Terrain terrain = Build(layout, GridGeometry::FromCells(kCells, kSize_m), 5);
  const Grid<unsigned char> streets = StreetCells(terrain);
  int built = 0;
  for (int r = 0; r < kCells; ++r) {
    for (int c = 0; c < kCells; ++c) {
      built += streets(r, c) != 0 && terrain.weights.DominantAt({r, c}) == 'B';
    }
  }
  EXPECT_GT(built, CountOf(streets) / 2);
  // A cell of 8 m cannot show a lane of 4 m.
  const Terrain coarse = Build(layout, GridGeometry::FromCells(64, kSize_m), 5);
  EXPECT_EQ(CountOf(StreetCells(coarse)), 0);
}

TEST(StreetsTest, WildWorldsHaveNone) {
  SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kWild, 'B');
  const Terrain terrain = Build(layout, GridGeometry::FromCells(128, kSize_m), 1);
  EXPECT_EQ(CountOf(RoadCells(terrain)), 0);
}

}  // namespace
}  // namespace latticeworld
