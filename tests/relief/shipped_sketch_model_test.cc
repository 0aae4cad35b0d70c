#include <gtest/gtest.h>

#include <cstdint>

#include "latticeworld/relief/sketch/sketch.h"
#include "latticeworld/relief/sketch/sketch_model.h"
#include "relief/sketch_round_trip.h"

namespace latticeworld {
namespace {

// Land of which the model has seen nothing, drawn and made again with it and without it.
TEST(ShippedSketchModelTest, ItsLandIsMoreLikeTheLandThatWasDrawnAndItsStrokesHold) {
  Result<SketchModel> model = SketchModel::Load(LATTICEWORLD_SHIPPED_SKETCH_MODEL);
  ASSERT_TRUE(model.ok()) << model.status().ToString();
  constexpr int kCells = 256, kLands = 12;
  double learned = 0.0, solved = 0.0;
  for (std::uint64_t seed = 0; seed < kLands; ++seed) {
    const Grid<float> land = ErodedLand(kCells, seed);
    const Sketch sketch = DrawSketch(land, seed % 2 == 0 ? 0.01 : 0.03);
    SketchOptions options;
    options.samples = kCells;
    options.seed = seed;
    const Grid<float> made = SketchToHeight(sketch, *model, options, Progress()).value();
    learned += Correlation(land, made) / kLands;
    solved += Correlation(land, SketchToHeight(sketch, options, Progress()).value()) / kLands;
    const RightSides right = MeasureStrokes(sketch, made);
    EXPECT_GE(right.of_other, 0.95) << "seed " << seed;
    EXPECT_GE(right.of_mean, 0.95) << "seed " << seed;
  }
  EXPECT_GT(learned, solved);
}

}  // namespace
}  // namespace latticeworld
