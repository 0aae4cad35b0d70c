#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_SMOOTH_FIELD_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_SMOOTH_FIELD_H_

#include <cstdint>

#include "latticeworld/geometry/grid.h"

namespace latticeworld {

// Smooth noise in [0, 1] over a layout's cells, (32 x 32): two octaves, the larger one with
// the given wavelength [cells].
Grid<float> SmoothField(std::uint64_t seed, double wavelength);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_SMOOTH_FIELD_H_
