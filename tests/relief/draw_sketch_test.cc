#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>

#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/erosion.h"
#include "latticeworld/geomorphology/noise.h"
#include "latticeworld/relief/sketch.h"

namespace latticeworld {
namespace {

// Land that rivers made: rolling ground, lifted unevenly while streams cut into it. The middle of a
// larger piece, so that its border is no coast.
Grid<float> ErodedLand(int cells, std::uint64_t seed) {
  const int margin = cells / 4;
  const int all = cells + 2 * margin;
  const GridGeometry geometry = GridGeometry::FromCells(all, 16.0 * all);
  NoiseOptions rolling;
  rolling.wavelength_m = 6.0 * cells;
  rolling.octaves = 7;
  Grid<float> height = FractalNoise(geometry, rolling, StreamSeed(seed, "rolling"));
  rolling.octaves = 2;
  Grid<float> uplift = FractalNoise(geometry, rolling, StreamSeed(seed, "uplift"));
  for (float& h : height) h = 300.0f * h;
  for (float& u : uplift) u = 5e-4f * std::max(0.1f, 1.0f + 1.5f * u);
  FluvialOptions options;
  options.steps = 20;
  options.time_step_yr = 3e4;
  options.erodibility = 2e-5;
  options.area_exponent = 0.45;
  ErodeFluvially(geometry.resolution_m(), options, nullptr, &uplift, nullptr, 0, &height);
  Grid<float> middle(cells, cells);
  for (int r = 0; r < cells; ++r) {
    std::copy(height.row(r + margin) + margin, height.row(r + margin) + margin + cells,
              middle.row(r));
  }
  return middle;
}

// Height at the nearest stroke of a kind; false when there is none.
bool NearestHeight(Stroke stroke, const Sketch& sketch, const Grid<float>& height, CellIndex cell,
                   float* nearest) {
  int best = std::numeric_limits<int>::max();
  for (int reach = 1; reach < sketch.rows() && (reach - 1) * (reach - 1) <= best; ++reach) {
    for (int r = cell.row - reach; r <= cell.row + reach; ++r) {
      const bool whole_row = r == cell.row - reach || r == cell.row + reach;
      for (int c = cell.col - reach; c <= cell.col + reach; c += whole_row ? 1 : 2 * reach) {
        if (!sketch.Contains({r, c}) || sketch(r, c) != stroke) continue;
        const int distance = (r - cell.row) * (r - cell.row) + (c - cell.col) * (c - cell.col);
        if (distance >= best) continue;
        best = distance;
        *nearest = height(r, c);
      }
    }
  }
  return best < std::numeric_limits<int>::max();
}

TEST(DrawSketchTest, DrawsARoofAndAGutter) {
  // Two roofs side by side that fall to a gutter between them, all of it leaning north a little.
  Grid<float> height(40, 41);
  for (int r = 0; r < 40; ++r) {
    for (int c = 0; c < 41; ++c) {
      const int from_gutter = std::abs(c - 20);
      height(r, c) = static_cast<float>(from_gutter <= 10 ? from_gutter : 20 - from_gutter) +
                     0.01f * static_cast<float>(r);
    }
  }
  const Sketch sketch = DrawSketch(height, 0.06);
  for (int r = 12; r < 28; ++r) {
    for (int c = 5; c < 36; ++c) {
      const Stroke expected = c == 20              ? Stroke::kValley
                              : c == 10 || c == 30 ? Stroke::kRidge
                                                   : Stroke::kNone;
      EXPECT_EQ(sketch(r, c), expected) << "row " << r << ", column " << c;
    }
  }
}

TEST(DrawSketchTest, DrawsNoMoreThanItsShareOfEach) {
  for (const double share : {0.005, 0.02, 0.1}) {
    const Sketch sketch = DrawSketch(ErodedLand(128, 3), share);
    const double cells = static_cast<double>(sketch.size());
    const auto count = [&](Stroke s) { return std::count(sketch.begin(), sketch.end(), s); };
    EXPECT_LE(count(Stroke::kValley), share * cells);
    EXPECT_GT(count(Stroke::kValley), 0.5 * share * cells);
    EXPECT_LE(count(Stroke::kRidge), share * cells);
    EXPECT_GT(count(Stroke::kRidge), 0.5 * share * cells);
  }
}

TEST(DrawSketchTest, LevelLandHasNoStrokes) {
  const Sketch sketch = DrawSketch(Grid<float>(64, 64, 5.0f), 0.02);
  EXPECT_LT(std::count(sketch.begin(), sketch.end(), Stroke::kRidge), 0.02 * 64 * 64 + 1);
}

// There and back: of the pixels of each kind of stroke at least 95 % lie on the right side of the
// nearest stroke of the other kind, and of the mean height around them (a Gaussian of 1/32 of the
// side).
TEST(DrawSketchTest, LandMadeOfItsSketchHasValleysBelowAndRidgesAbove) {
  constexpr int kCells = 256;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Sketch sketch = DrawSketch(ErodedLand(kCells, seed), seed % 2 == 0 ? 0.01 : 0.03);
    SketchOptions options;
    options.samples = kCells;
    options.seed = seed;
    const Grid<float> height = SketchToHeight(sketch, options, Progress()).value();
    Grid<float> mean = height;
    GaussianBlur(kCells / 32.0, &mean);
    double pixels = 0.0;
    double right_of_other = 0.0;
    double right_of_mean = 0.0;
    for (int r = 0; r < kCells; ++r) {
      for (int c = 0; c < kCells; ++c) {
        const Stroke stroke = sketch(r, c);
        if (stroke == Stroke::kNone) continue;
        const bool valley = stroke == Stroke::kValley;
        float other = 0.0f;
        ASSERT_TRUE(NearestHeight(valley ? Stroke::kRidge : Stroke::kValley, sketch, height, {r, c},
                                  &other));
        pixels += 1.0;
        right_of_other += valley ? height(r, c) < other : height(r, c) > other;
        right_of_mean += valley ? height(r, c) < mean(r, c) : height(r, c) > mean(r, c);
      }
    }
    EXPECT_GE(right_of_other / pixels, 0.95) << "seed " << seed;
    EXPECT_GE(right_of_mean / pixels, 0.95) << "seed " << seed;
  }
}

}  // namespace
}  // namespace latticeworld
