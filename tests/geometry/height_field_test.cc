#include "latticeworld/geometry/height_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

HeightField Noise(int cells, double size_m, std::uint64_t seed) {
  RandomStream random(seed, "heights");
  Grid<float> height_m(cells, cells);
  for (float& height : height_m) height = static_cast<float>(random.Uniform(-3.0, 9.0));
  return HeightField(GridGeometry::FromCells(cells, size_m), height_m);
}

TEST(HeightFieldTest, PassesThroughTheCellCentres) {
  const HeightField field = Noise(16, 8.0, 1);
  for (int row = 0; row < 16; ++row) {
    for (int col = 0; col < 16; ++col) {
      ASSERT_NEAR(field.HeightAt(field.geometry().CenterOf({row, col})), field.height_m()(row, col),
                  1e-5);
    }
  }
}

TEST(HeightFieldTest, SplitsQuadsFromNorthWestToSouthEast) {
  Grid<float> height_m(2, 2, 0.0f);
  height_m(0, 1) = 1.0f;  // the north-east vertex is off the diagonal: the diagonal stays at 0
  const HeightField field(GridGeometry::FromCells(2, 2.0), height_m);
  EXPECT_NEAR(field.HeightAt({0.0, 0.0}), 0.0, 1e-9);
  EXPECT_NEAR(field.HeightAt({0.25, 0.25}), 0.5, 1e-9);
  EXPECT_NEAR(field.HeightAt({-0.25, -0.25}), 0.0, 1e-9);
}

TEST(HeightFieldTest, APlaneHasItsHeightNormalAndSlopeEverywhere) {
  const GridGeometry geometry = GridGeometry::FromCells(20, 10.0);
  Grid<float> height_m(20, 20);
  for (int row = 0; row < 20; ++row) {
    for (int col = 0; col < 20; ++col) {
      const WorldPoint p = geometry.CenterOf({row, col});
      height_m(row, col) = static_cast<float>(0.5 * p.x_m - 0.25 * p.y_m + 3.0);
    }
  }
  const HeightField field(geometry, height_m);
  const Eigen::Vector3d normal = Eigen::Vector3d(-0.5, 0.25, 1.0).normalized();
  RandomStream random(2, "points");
  for (int i = 0; i < 1000; ++i) {
    const WorldPoint p = {random.Uniform(-4.7, 4.7), random.Uniform(-4.7, 4.7)};
    ASSERT_NEAR(field.HeightAt(p), 0.5 * p.x_m - 0.25 * p.y_m + 3.0, 1e-5);
    ASSERT_NEAR((field.NormalAt(p) - normal).norm(), 0.0, 1e-5);
    ASSERT_NEAR(field.SlopeAt(p), std::atan(std::hypot(0.5, 0.25)), 1e-5);
  }
}

TEST(HeightFieldTest, IsContinuousAndWithinItsBounds) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const HeightField field = Noise(24, 12.0, seed);
    RandomStream random(seed, "walk");
    for (int i = 0; i < 500; ++i) {
      const WorldPoint p = {random.Uniform(-6.5, 6.5), random.Uniform(-6.5, 6.5)};
      const WorldPoint q = {p.x_m + 1e-7, p.y_m - 1e-7};
      ASSERT_NEAR(field.HeightAt(p), field.HeightAt(q), 1e-5);
      ASSERT_GE(field.HeightAt(p), field.min_m() - 1e-5);
      ASSERT_LE(field.HeightAt(p), field.max_m() + 1e-5);
      ASSERT_GT(field.NormalAt(p).z(), 0.0);
    }
  }
}

TEST(HeightFieldTest, GoesOnFromItsEdge) {
  const HeightField field = Noise(8, 8.0, 3);
  EXPECT_NEAR(field.HeightAt({-100.0, 100.0}), field.height_m()(0, 0), 1e-5);
  EXPECT_NEAR(field.HeightAt({100.0, -100.0}), field.height_m()(7, 7), 1e-5);
}

}  // namespace
}  // namespace latticeworld
