#ifndef LATTICEWORLD_GEOMORPHOLOGY_BLUR_H_
#define LATTICEWORLD_GEOMORPHOLOGY_BLUR_H_

#include "latticeworld/geometry/grid.h"

namespace latticeworld {

// Gaussian blur of standard deviation sigma_cells [cells] in place, as three box blurs (Wells 1986,
// "Efficient synthesis of Gaussian filters by cascaded uniform filters"); beyond the edge the
// nearest cell continues. The widths come in whole cells: a sigma below about 0.6 changes nothing.
// threads: 0 for as many as cores; the result is the same with any.
void GaussianBlur(double sigma_cells, Grid<float>* values, int threads = 0);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GEOMORPHOLOGY_BLUR_H_
