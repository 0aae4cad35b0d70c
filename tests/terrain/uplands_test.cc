#include "latticeworld/terrain/uplands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "latticeworld/geomorphology/flow.h"

namespace latticeworld::internal {
namespace {

constexpr int kCells = 96;

GridGeometry Lattice() { return GridGeometry::FromCells(kCells, 192.0); }

// Falls to the south [m/m].
Grid<float> Slope(double slope) {
  Grid<float> height_m(kCells, kCells);
  for (int r = 0; r < kCells; ++r) {
    for (int c = 0; c < kCells; ++c) {
      height_m(r, c) = static_cast<float>(slope * 2.0 * (kCells - 1 - r));
    }
  }
  return height_m;
}

// A round hill 30 m high and 60 m from its top to its foot.
Grid<float> Hill() {
  Grid<float> height_m(kCells, kCells);
  for (int r = 0; r < kCells; ++r) {
    for (int c = 0; c < kCells; ++c) {
      const WorldPoint at = Lattice().CenterOf({r, c});
      const double u = std::min(std::hypot(at.x_m, at.y_m) / 60.0, 1.0);
      height_m(r, c) = static_cast<float>(30.0 * (1.0 - u * u * (3.0 - 2.0 * u)));
    }
  }
  return height_m;
}

Grid<unsigned char> Border() {
  Grid<unsigned char> border(kCells, kCells, 0);
  for (int i = 0; i < kCells; ++i) {
    border(0, i) = border(kCells - 1, i) = border(i, 0) = border(i, kCells - 1) = 1;
  }
  return border;
}

// Heights of the cells that lie so far from the middle, to a cell.
std::vector<double> Ring(const Grid<float>& height_m, double radius_m) {
  std::vector<double> heights;
  for (int r = 0; r < kCells; ++r) {
    for (int c = 0; c < kCells; ++c) {
      const WorldPoint at = Lattice().CenterOf({r, c});
      if (std::abs(std::hypot(at.x_m, at.y_m) - radius_m) < 1.0) heights.push_back(height_m(r, c));
    }
  }
  return heights;
}

double Mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

TEST(RoughenSlopesTest, LevelGroundStaysAndTwiceTheSlopeIsTwiceAsRough) {
  Grid<float> level(kCells, kCells, 7.0f);
  RoughenSlopes(Lattice(), 0.4, 1, &level);
  EXPECT_EQ(level, Grid<float>(kCells, kCells, 7.0f));
  Grid<float> gentle = Slope(0.1), steep = Slope(0.2);
  RoughenSlopes(Lattice(), 0.4, 1, &gentle);
  RoughenSlopes(Lattice(), 0.4, 1, &steep);
  double most_m = 0.0;
  for (int r = 0; r < kCells; ++r) {
    for (int c = 0; c < kCells; ++c) {
      const double rough_m = gentle(r, c) - Slope(0.1)(0, 0) * (kCells - 1 - r) / (kCells - 1);
      const double twice_m = steep(r, c) - Slope(0.2)(0, 0) * (kCells - 1 - r) / (kCells - 1);
      ASSERT_NEAR(twice_m, 2.0 * rough_m, 1e-3);
      most_m = std::max(most_m, std::abs(rough_m));
    }
  }
  EXPECT_GT(most_m, 0.3);
}

TEST(RoughenSlopesTest, WaterOnAPlaneSlopeGathers) {
  const Grid<unsigned char> border = Border();
  Grid<float> plane = Slope(0.3);
  const auto most_cells = [&](const Grid<float>& land_m) {
    const Grid<float> area = FlowAccumulation(RouteFlow(land_m, &border), nullptr);
    return *std::max_element(area.begin(), area.end());
  };
  EXPECT_LE(most_cells(plane), kCells);
  RoughenSlopes(Lattice(), 0.4, 3, &plane);
  EXPECT_GT(most_cells(plane), 3 * kCells);
}

TEST(LowerSummitsTest, WhatATenthIsHigherThanIsLoweredToItsShareAndHeightsKeepTheirOrder) {
  constexpr double kStrength = 1.5;
  const Grid<float> foot_m(kCells, kCells, 5.0f);
  const Grid<float> before_m = Hill();
  Grid<float> land_m = before_m;
  LowerSummits(kStrength, foot_m, &land_m);
  std::vector<std::pair<float, float>> pairs;
  for (std::size_t i = 0; i < land_m.size(); ++i) {
    pairs.emplace_back(before_m.data()[i], land_m.data()[i]);
    // What lies below its foot stays.
    if (before_m.data()[i] <= 5.0f) {
      ASSERT_EQ(land_m.data()[i], before_m.data()[i]);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  const auto [was_m, is_m] = pairs[pairs.size() * 9 / 10];
  EXPECT_NEAR(is_m, 5.0 + (was_m - 5.0) / (1.0 + kStrength), 0.01);
  for (std::size_t i = 0; i + 1 < pairs.size(); ++i) {
    ASSERT_LE(pairs[i].second, pairs[i + 1].second + 1e-4f);
  }
}

TEST(LowerSummitsTest, HeightsCountFromTheirOwnFoot) {
  Grid<float> foot_m(kCells, kCells, 0.0f);
  Grid<float> land_m = Hill(), raised_m = Hill();
  for (std::size_t i = 0; i < foot_m.size(); ++i) {
    foot_m.data()[i] = 40.0f * static_cast<float>(i % kCells) / kCells;
    raised_m.data()[i] += foot_m.data()[i];
  }
  LowerSummits(2.0, Grid<float>(kCells, kCells, 0.0f), &land_m);
  LowerSummits(2.0, foot_m, &raised_m);
  for (std::size_t i = 0; i < foot_m.size(); ++i) {
    ASSERT_NEAR(raised_m.data()[i] - foot_m.data()[i], land_m.data()[i], 1e-3);
  }
}

TEST(LowerSummitsTest, LevelLandStays) {
  Grid<float> land_m(kCells, kCells, 3.0f);
  LowerSummits(2.0, Grid<float>(kCells, kCells, 3.0f), &land_m);
  EXPECT_EQ(land_m, Grid<float>(kCells, kCells, 3.0f));
}

TEST(DissectTest, AHillGetsValleysAndSpursAndKeepsItsFormOnTheMean) {
  const Grid<float> before_m = Hill();
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Grid<float> land_m = before_m;
    Dissect(Lattice(), Border(), seed, &land_m);
    for (const double radius_m : {20.0, 30.0, 40.0}) {
      const std::vector<double> was = Ring(before_m, radius_m), is = Ring(land_m, radius_m);
      EXPECT_NEAR(Mean(is), Mean(was), 3.0) << seed << ", " << radius_m;
      const auto [low, high] = std::minmax_element(is.begin(), is.end());
      const auto [was_low, was_high] = std::minmax_element(was.begin(), was.end());
      EXPECT_GT(*high - *low, *was_high - *was_low + 2.0) << seed << ", " << radius_m;
    }
  }
}

TEST(DissectTest, WhereWaterLeavesNothingChangesButByRoughness) {
  const Grid<unsigned char> border = Border();
  Grid<float> land_m = Hill();
  Dissect(Lattice(), border, 2, &land_m);
  for (std::size_t i = 0; i < border.size(); ++i) {
    if (border.data()[i] != 0) {
      ASSERT_NEAR(land_m.data()[i], Hill().data()[i], 0.05);
    }
  }
}

}  // namespace
}  // namespace latticeworld::internal
