#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/terrain/components.h"
#include "terrain/terrain_building.h"

namespace latticeworld {
namespace {

constexpr int kSeeds = 20;

// A river from the north into a round lake and on to the south edge.
SymbolicLayout RiverAndLake(Vocabulary vocabulary) {
  SymbolicLayout layout =
      testing_layouts::Filled(vocabulary, vocabulary == Vocabulary::kSuburb ? 'G' : 'B');
  for (int r = 0; r < kLayoutSize; ++r) {
    layout.cells(r, 15 + static_cast<int>(std::lround(4.0 * std::sin(r / 4.0)))) = 'W';
  }
  testing_layouts::PaintDisc('W', 15.5, 15, 4.5, &layout);
  return layout;
}

// The sea in the south and in the north-east, which have no connection.
SymbolicLayout TwoSeas() {
  SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kSuburb, 'G');
  for (int c = 0; c < kLayoutSize; ++c) {
    for (int r = 27; r < kLayoutSize; ++r) layout.cells(r, c) = 'W';
  }
  for (int r = 0; r < 10; ++r) {
    for (int c = 26; c < kLayoutSize; ++c) layout.cells(r, c) = 'W';
  }
  return layout;
}

// Levels of the wet cells whose layout cell is in a rectangle.
std::vector<float> LevelsIn(const Terrain& terrain, int row_low, int row_high, int col_low,
                            int col_high) {
  std::vector<float> levels;
  const int cells = terrain.geometry().rows();
  for (int r = row_low * cells / 32; r < (row_high + 1) * cells / 32; ++r) {
    for (int c = col_low * cells / 32; c < (col_high + 1) * cells / 32; ++c) {
      if (IsWet(terrain, r, c)) levels.push_back(terrain.water_level_m(r, c));
    }
  }
  return levels;
}

TEST(WaterTest, LakesAreLevelToTheBit) {
  const Relief relief = Valley();
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const Vocabulary vocabulary = seed % 2 == 0 ? Vocabulary::kSuburb : Vocabulary::kWild;
    const Terrain terrain = Build(RiverAndLake(vocabulary), GridGeometry::FromCells(320, 190.0),
                                  seed, seed % 3 == 0 ? &relief : nullptr);
    const std::vector<float> levels = LevelsIn(terrain, 13, 18, 13, 17);
    ASSERT_GT(levels.size(), 2000u);
    const auto [low, high] = std::minmax_element(levels.begin(), levels.end());
    EXPECT_EQ(*low, *high) << "seed " << seed;
  }
}

TEST(WaterTest, TheSeaHasOneLevel) {
  const Relief relief = Hills();
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const Terrain terrain = Build(TwoSeas(), GridGeometry::FromCells(256, 190.0), seed,
                                  seed % 2 == 0 ? &relief : nullptr);
    const std::vector<float> south = LevelsIn(terrain, 29, 31, 2, 29);
    const std::vector<float> north_east = LevelsIn(terrain, 1, 6, 29, 30);
    ASSERT_FALSE(south.empty());
    ASSERT_FALSE(north_east.empty());
    EXPECT_EQ(*std::min_element(south.begin(), south.end()),
              *std::max_element(south.begin(), south.end()));
    EXPECT_EQ(south.front(), north_east.front()) << "seed " << seed;
    EXPECT_EQ(*std::min_element(north_east.begin(), north_east.end()),
              *std::max_element(north_east.begin(), north_east.end()));
  }
}

// Mean level and lowest bed of a river that runs from north to south, by row.
struct Profile {
  std::vector<double> level_m;
  std::vector<double> bed_m;
};
Profile ProfileOf(const Terrain& terrain, int row_begin, int row_end) {
  Profile profile;
  for (int r = row_begin; r < row_end; ++r) {
    double sum = 0.0, bed = 1e9;
    int count = 0;
    for (int c = 0; c < terrain.geometry().cols(); ++c) {
      if (!IsWet(terrain, r, c)) continue;
      sum += terrain.water_level_m(r, c);
      bed = std::min<double>(bed, terrain.ground.height_m()(r, c));
      ++count;
    }
    EXPECT_GT(count, 0) << "the river is cut in row " << r;
    if (count == 0) continue;
    profile.level_m.push_back(sum / count);
    profile.bed_m.push_back(bed);
  }
  // From its higher end.
  if (!profile.level_m.empty() && profile.level_m.front() < profile.level_m.back()) {
    std::reverse(profile.level_m.begin(), profile.level_m.end());
    std::reverse(profile.bed_m.begin(), profile.bed_m.end());
  }
  return profile;
}

TEST(WaterTest, RiversAndTheirBedsFallAlongTheCourse) {
  SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kSuburb, 'G');
  for (int r = 0; r < kLayoutSize; ++r) {
    layout.cells(r, 15 + static_cast<int>(std::lround(3.0 * std::sin(r / 6.0)))) = 'W';
  }
  const Relief relief = Valley();
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const bool given = seed % 4 == 0;
    const Terrain terrain =
        Build(layout, GridGeometry::FromCells(512, 512.0), seed, given ? &relief : nullptr);
    const Profile profile = ProfileOf(terrain, 0, 512);
    // Rows cut the course at a slant: what is uphill in a row may be downhill along the course.
    const double slack_m = given ? 0.10 : 0.01;
    double lowest_level = 1e9, lowest_bed = 1e9;
    for (std::size_t i = 0; i < profile.level_m.size(); ++i) {
      EXPECT_LT(profile.level_m[i], lowest_level + slack_m) << "seed " << seed << " at " << i;
      EXPECT_LT(profile.bed_m[i], lowest_bed + slack_m + 0.02) << "seed " << seed << " at " << i;
      lowest_level = std::min(lowest_level, profile.level_m[i]);
      lowest_bed = std::min(lowest_bed, profile.bed_m[i]);
    }
    EXPECT_GT(profile.level_m.front() - profile.level_m.back(), given ? 25.0 : 1.0);
    EXPECT_GT(profile.bed_m.front() - profile.bed_m.back(), given ? 25.0 : 1.0);
  }
}

TEST(WaterTest, ARiverRunsIntoItsLakeAndOutOfIt) {
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const Terrain terrain =
        Build(RiverAndLake(Vocabulary::kSuburb), GridGeometry::FromCells(320, 190.0), seed);
    const Profile profile = ProfileOf(terrain, 0, 320);
    double lowest = 1e9;
    for (const double level : profile.level_m) {
      EXPECT_LT(level, lowest + 0.01) << "seed " << seed;
      lowest = std::min(lowest, level);
    }
    const double lake_m = LevelsIn(terrain, 15, 16, 14, 16).front();
    EXPECT_GT(profile.level_m.front(), lake_m + 0.05);
    EXPECT_LT(profile.level_m.back(), lake_m - 0.05);
  }
}

// Land beside water stands above it, not only its outermost cell, so that the water is held.
TEST(WaterTest, WaterIsHeldByItsShores) {
  const Relief relief = Hills();
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const SymbolicLayout layout = seed % 2 == 0 ? testing_layouts::Blobs(Vocabulary::kWild, seed)
                                                : testing_layouts::Blobs(Vocabulary::kSuburb, seed);
    const int cells = 512;
    const Terrain terrain = Build(layout, GridGeometry::FromCells(cells, 512.0), seed,
                                  seed % 3 == 0 ? &relief : nullptr);
    int shore = 0, low = 0;
    constexpr int kReach = 2;  // metres
    for (int r = kReach; r < cells - kReach; ++r) {
      for (int c = kReach; c < cells - kReach; ++c) {
        if (IsWet(terrain, r, c) || terrain.surface(r, c) == SurfaceClass::kRoad) continue;
        float highest = -1e9f, lowest = 1e9f;
        for (int i = -kReach; i <= kReach; ++i) {
          for (int k = -kReach; k <= kReach; ++k) {
            if (!IsWet(terrain, r + i, c + k)) continue;
            highest = std::max(highest, terrain.water_level_m(r + i, c + k));
            lowest = std::min(lowest, terrain.water_level_m(r + i, c + k));
          }
        }
        // Between two waters the land leads from one to the other.
        if (highest < -1e8f || highest > lowest + 0.05f) continue;
        ++shore;
        low += terrain.ground.height_m()(r, c) < highest;
      }
    }
    EXPECT_GT(shore, 500);
    EXPECT_LE(low, 0.03 * shore) << "seed " << seed;
  }
}

// The steepest that dry land near water may be, built or not, without a cliff of the user's own.
constexpr double kSteepestBank_deg = 42.0;

TEST(WaterTest, BanksAreNeverSteepEvenBetweenWatersThatNearlyMeet) {
  const Relief relief = Hills();
  for (int seed = 1; seed <= kSeeds; ++seed) {
    SymbolicLayout layout = testing_layouts::Checker(Vocabulary::kWild, 'R', 'W');
    if (seed % 3 == 1) layout = testing_layouts::AnyLetters(Vocabulary::kWild, seed);
    if (seed % 3 == 2) layout = testing_layouts::Blobs(Vocabulary::kSuburb, seed);
    const bool given = seed % 2 == 0;
    const Terrain terrain =
        Build(layout, GridGeometry::FromCells(512, 512.0), seed, given ? &relief : nullptr);
    const Grid<float> slope = GradientMagnitude(terrain.ground.height_m(), 1.0);
    Grid<unsigned char> wet(512, 512);
    for (int r = 0; r < 512; ++r) {
      for (int c = 0; c < 512; ++c) wet(r, c) = IsWet(terrain, r, c);
    }
    const Grid<float> to_water = DistanceTo(true, wet);
    std::vector<double> banks_deg;
    for (std::size_t i = 0; i < slope.size(); ++i) {
      if (wet.data()[i] != 0 || to_water.data()[i] > 8.0f) continue;
      banks_deg.push_back(std::atan(slope.data()[i]) * 180.0 / M_PI);
    }
    std::sort(banks_deg.begin(), banks_deg.end());
    EXPECT_LT(At(banks_deg, 1.0), kSteepestBank_deg) << "seed " << seed;
  }
}

}  // namespace
}  // namespace latticeworld
