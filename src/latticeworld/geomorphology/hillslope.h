#ifndef LATTICEWORLD_GEOMORPHOLOGY_HILLSLOPE_H_
#define LATTICEWORLD_GEOMORPHOLOGY_HILLSLOPE_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid.h"

namespace latticeworld::internal {

// One implicit step of diffusion, along one axis and then along the other (locally one-dimensional,
// Marchuk 1990): stable for any number = diffusivity * time / cell^2. Cells that are kOutlet in
// directions stay; nothing crosses the border of the grid. The result does not depend on threads.
void Diffuse(double number, const std::vector<std::uint8_t>& directions, bool rows_first,
             int threads, Grid<float>* height_m);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_GEOMORPHOLOGY_HILLSLOPE_H_
