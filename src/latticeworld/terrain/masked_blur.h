#ifndef LATTICEWORLD_TERRAIN_MASKED_BLUR_H_
#define LATTICEWORLD_TERRAIN_MASKED_BLUR_H_

#include "latticeworld/geometry/grid.h"

namespace latticeworld::internal {

// A Gaussian mean of the masked cells alone: sum(mask * value) / sum(mask).
struct MaskedBlur {
  Grid<float> value;  // meaningful where share is not tiny
  Grid<float> share;  // of masked cells, in [0, 1]
};
MaskedBlur BlurMasked(const Grid<unsigned char>& mask, const Grid<float>& values,
                      double sigma_cells);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_MASKED_BLUR_H_
