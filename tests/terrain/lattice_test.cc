#include "latticeworld/terrain/lattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/resample.h"

namespace latticeworld::internal {
namespace {

Grid<float> Read(const Grid<float>& source, int cells, RowSampler::Kernel kernel) {
  const RowSampler sampler(source, cells, kernel);
  Grid<float> values(cells, cells);
  std::vector<float> scratch;
  for (int r = 0; r < cells; ++r) sampler.Row(r, &scratch, values.row(r));
  return values;
}

Grid<float> Noise(int rows, int cols, std::uint64_t seed) {
  RandomStream random(seed, "lattice_test");
  Grid<float> values(rows, cols);
  for (float& value : values) value = static_cast<float>(random.Uniform());
  return values;
}

TEST(LatticeTest, DependsOnTheSizeOfTheWorldAlone) {
  for (const double size_m : {16.0, 199.0, 200.0, 512.0, 8192.0}) {
    const int cells = LatticeOf(GridGeometry::FromCells(64, size_m)).rows();
    EXPECT_EQ(cells, LatticeOf(GridGeometry::FromCells(2048, size_m)).rows());
    EXPECT_LE(cells, 512);
    EXPECT_EQ(cells % 32, 0);
  }
}

TEST(RowSamplerTest, TheSmoothKernelStaysWithinItsValuesAndKeepsPlanes) {
  Grid<float> plane(40, 40);
  for (int r = 0; r < 40; ++r) {
    for (int c = 0; c < 40; ++c) plane(r, c) = 2.0f * r - 0.5f * c;
  }
  const Grid<float> fine = Read(plane, 120, RowSampler::Kernel::kSmooth);
  for (int r = 9; r < 111; ++r) {
    for (int c = 9; c < 111; ++c) {
      ASSERT_NEAR(fine(r, c), 2.0 * ((r + 0.5) / 3.0 - 0.5) - 0.5 * ((c + 0.5) / 3.0 - 0.5), 1e-4);
    }
  }
  for (const float value : Read(Noise(32, 32, 1), 77, RowSampler::Kernel::kSmooth)) {
    ASSERT_GE(value, 0.0f);
    ASSERT_LE(value, 1.0f);
  }
}

TEST(RowSamplerTest, TheOtherKernelIsTheOneOfResample) {
  const Grid<float> source = Noise(33, 47, 2);
  const Grid<float> read = Read(source, 90, RowSampler::Kernel::kThrough);
  const Grid<float> expected = Resample(source, 90, 90);
  for (std::size_t i = 0; i < read.size(); ++i) {
    ASSERT_NEAR(read.data()[i], expected.data()[i], 1e-5);
  }
  const Grid<float> square = Noise(50, 50, 3);
  EXPECT_EQ(Read(square, 50, RowSampler::Kernel::kThrough), square);
}

TEST(SplineCoefficientsTest, TheSmoothKernelReadsTheValuesBack) {
  const Grid<float> values = Noise(60, 60, 4);
  const Grid<float> read = Read(SplineCoefficients(values), 60, RowSampler::Kernel::kSmooth);
  double rounded_off = 0.0;
  const Grid<float> smooth = Read(values, 60, RowSampler::Kernel::kSmooth);
  // At the edges the sampler goes on level, where the coefficients are mirrored.
  for (int r = 10; r < 50; ++r) {
    for (int c = 10; c < 50; ++c) {
      ASSERT_NEAR(read(r, c), values(r, c), 1e-4);
      rounded_off = std::max(rounded_off, std::abs(smooth(r, c) - values(r, c)) + 0.0);
    }
  }
  EXPECT_GT(rounded_off, 0.1);
}

TEST(SplineCoefficientsTest, OfLevelValuesAreTheValues) {
  const Grid<float> level(17, 40, 6.5f);
  for (const float value : SplineCoefficients(level)) ASSERT_NEAR(value, 6.5f, 1e-4);
}

}  // namespace
}  // namespace latticeworld::internal
