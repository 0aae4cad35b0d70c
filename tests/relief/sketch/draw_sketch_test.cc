#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "latticeworld/relief/sketch/sketch.h"
#include "relief/sketch_round_trip.h"

namespace latticeworld {
namespace {

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

// There and back.
TEST(DrawSketchTest, LandMadeOfItsSketchHasValleysBelowAndRidgesAbove) {
  constexpr int kCells = 256;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Sketch sketch = DrawSketch(ErodedLand(kCells, seed), seed % 2 == 0 ? 0.01 : 0.03);
    SketchOptions options;
    options.samples = kCells;
    options.seed = seed;
    const RightSides right =
        MeasureStrokes(sketch, SketchToHeight(sketch, options, Progress()).value());
    EXPECT_GE(right.of_other, 0.95) << "seed " << seed;
    EXPECT_GE(right.of_mean, 0.95) << "seed " << seed;
  }
}

}  // namespace
}  // namespace latticeworld
