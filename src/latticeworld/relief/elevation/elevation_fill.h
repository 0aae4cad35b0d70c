#ifndef LATTICEWORLD_RELIEF_ELEVATION_ELEVATION_FILL_H_
#define LATTICEWORLD_RELIEF_ELEVATION_ELEVATION_FILL_H_

#include "latticeworld/geometry/grid.h"

namespace latticeworld::internal {

// Gives every NaN a height: a membrane spanned between what lies around it, level where it meets
// the border. Returns the share of the cells that were NaN; where all were, 1 and nothing is
// changed.
double FillVoids(Grid<float>* height_m);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_ELEVATION_ELEVATION_FILL_H_
