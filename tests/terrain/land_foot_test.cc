#include "latticeworld/terrain/land_foot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "terrain/terrain_building.h"

namespace latticeworld::internal {
namespace {

constexpr int kCells = 128;

GridGeometry Lattice() { return GridGeometry::FromCells(kCells, 256.0); }

WaterBodies Bodies(const Grid<unsigned char>& wet) { return FindWaterBodies(wet, 4.0, true); }

Grid<float> Levels(const Grid<unsigned char>& wet, double at_south_m, double rise_m) {
  Grid<float> level_m(kCells, kCells, std::numeric_limits<float>::quiet_NaN());
  for (int r = 0; r < kCells; ++r) {
    for (int c = 0; c < kCells; ++c) {
      if (wet(r, c) == 0) continue;
      level_m(r, c) = static_cast<float>(at_south_m + rise_m * (kCells - 1 - r) / (kCells - 1));
    }
  }
  return level_m;
}

TEST(LandFootTest, WithoutWaterItIsTheHills) {
  Grid<float> hills_m(kCells, kCells, 2.0f);
  hills_m(3, 4) = 5.0f;
  const Grid<unsigned char> dry(kCells, kCells, 0);
  EXPECT_EQ(FootOf(Lattice(), Bodies(dry), Levels(dry, 0.0, 0.0), hills_m), hills_m);
}

TEST(LandFootTest, BesideARiverItIsAsHighAsTheRiver) {
  Grid<unsigned char> wet(kCells, kCells, 0);
  for (int r = 0; r < kCells; ++r) wet(r, 60) = wet(r, 61) = wet(r, 62) = 1;
  const Grid<float> level_m = Levels(wet, 1.0, 30.0);
  const Grid<float> foot_m =
      FootOf(Lattice(), Bodies(wet), level_m, Grid<float>(kCells, kCells, 2.0f));
  for (int r = 16; r < kCells - 16; ++r) {
    for (int c = 0; c < kCells; c += 9) ASSERT_NEAR(foot_m(r, c), level_m(r, 61), 0.5);
  }
}

TEST(LandFootTest, FromALakeThatNothingDrainsItFallsGentlyToTheHills) {
  Grid<unsigned char> wet(kCells, kCells, 0);
  for (int r = 54; r < 74; ++r) {
    for (int c = 54; c < 74; ++c) wet(r, c) = 1;
  }
  const Grid<float> foot_m =
      FootOf(Lattice(), Bodies(wet), Levels(wet, 9.0, 0.0), Grid<float>(kCells, kCells, 2.0f));
  EXPECT_NEAR(foot_m(64, 64), 9.0, 1e-3);
  EXPECT_NEAR(foot_m(64, 5), 2.0, 1e-3);
  for (int c = 75; c < kCells; ++c) {
    ASSERT_LE(foot_m(64, c), foot_m(64, c - 1) + 1e-4f);
    ASSERT_GE(foot_m(64, c), foot_m(64, c - 1) - 0.25f);  // 0.12 m/m over cells of 2 m
  }
}

// A river that climbs through mountains into the world lies at the foot of all the land around.
TEST(LandFootTest, NoRiverRunsAboveTheLandBesideIt) {
  SymbolicLayout layout = testing_layouts::Filled(Vocabulary::kWild, 'B');
  for (int r = 0; r < kLayoutSize; ++r) {
    for (int c = 0; c < kLayoutSize; ++c) {
      if (c > 18) layout.cells(r, c) = 'R';
    }
    layout.cells(r, 15 + r / 8) = 'W';
  }
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Terrain terrain = Build(layout, GridGeometry::FromCells(256, 190.0), seed);
    int dry = 0, below = 0;
    for (int r = 0; r < 256; ++r) {
      float level_m = std::numeric_limits<float>::quiet_NaN();
      for (int c = 0; c < 256; ++c) {
        if (IsWet(terrain, r, c)) level_m = terrain.water_level_m(r, c);
      }
      for (int c = 0; c < 256; ++c) {
        if (IsWet(terrain, r, c)) continue;
        ++dry;
        if (terrain.ground.height_m()(r, c) < level_m - 0.5f) ++below;
      }
    }
    EXPECT_LT(static_cast<double>(below) / dry, 0.03) << seed;
  }
}

}  // namespace
}  // namespace latticeworld::internal
