#include "latticeworld/language/grounded/synthesis/smooth_field.h"

#include <algorithm>

#include "latticeworld/geomorphology/noise.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

Grid<float> SmoothField(std::uint64_t seed, double wavelength) {
  // One metre stands for one cell.
  const GridGeometry cells = *GridGeometry::Create(kLayoutSize, 1.0);
  Grid<float> field = FractalNoise(cells, {wavelength, 2, 0.5}, seed);
  for (float& value : field) value = std::clamp(0.5f + 0.7f * value, 0.0f, 1.0f);
  return field;
}

}  // namespace latticeworld
