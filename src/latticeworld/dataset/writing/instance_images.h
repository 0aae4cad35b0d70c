#ifndef LATTICEWORLD_DATASET_WRITING_INSTANCE_IMAGES_H_
#define LATTICEWORLD_DATASET_WRITING_INSTANCE_IMAGES_H_

#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/relief/sketch/sketch.h"

namespace latticeworld {

// A relief as pictures, as a user could give it: both are read back by ReadHeightMap and
// ReadSketch.
struct InstanceImages {
  std::string height_png;  // 16-bit grey: height [m] = offset + scale * value / 65535
  double height_scale_m = 0.0;
  double height_offset_m = 0.0;
  std::string sketch_png;  // blue valley floors and black ridges on white
};
// sketch_share: as in DrawSketch. Errors: INTERNAL.
Result<InstanceImages> DrawImages(const Grid<float>& height_m, double sketch_share);

// PNG bytes of strokes on white, a pixel a cell. Errors: INTERNAL.
Result<std::string> SketchPng(const Sketch& sketch);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_WRITING_INSTANCE_IMAGES_H_
