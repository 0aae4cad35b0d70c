#ifndef LATTICEWORLD_GENERATION_BUNDLE_RASTER_FILES_H_
#define LATTICEWORLD_GENERATION_BUNDLE_RASTER_FILES_H_

#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld {

// A picture of heights: 16-bit greyscale PNG, height [m] = offset_m + scale_m * value / 65535,
// which is what ReadHeightMap does with these two numbers.
struct HeightPng {
  std::string png;
  double scale_m = 0.0;
  double offset_m = 0.0;
};
Result<HeightPng> EncodeHeights(const Grid<float>& height_m);

// A picture of water depths: 16-bit greyscale PNG, 0 dry, else
// depth [m] = scale_m * (value - 1) / 65534.
struct WaterPng {
  std::string png;
  double scale_m = 0.0;  // the greatest depth
};
Result<WaterPng> EncodeWaterDepths(const Terrain& terrain);

// 8-bit greyscale PNG, 0 .. 255 for a weight of 0 .. 1.
Result<std::string> EncodeWeights(const WeightGrid& weight);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_BUNDLE_RASTER_FILES_H_
