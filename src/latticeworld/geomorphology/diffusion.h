#ifndef LATTICEWORLD_GEOMORPHOLOGY_DIFFUSION_H_
#define LATTICEWORLD_GEOMORPHOLOGY_DIFFUSION_H_

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"

namespace latticeworld {

struct MembraneOptions {
  int cycles = 6;   // V-cycles on the finest grid, [0, 1000]; each cuts the error to at most 2/3
  int threads = 0;  // 0: as many as cores; the result is the same with any number
};

// The membrane that springs pull: the height h with
//   sum over the up to four neighbours (h - h_neighbour) + stiffness * (h - target) = 0
// in every cell, free at the border. stiffness: per cell, >= 0, somewhere > 0; 0 leaves a cell to
// its neighbours (harmonic interpolation), 1e4 and more nails it to its target, whose value does
// not matter where stiffness is 0 but has to be finite. Full multigrid (Briggs, Henson and
// McCormick 2000, "A multigrid tutorial"), linear in the number of cells. Errors: CANCELLED.
Result<Grid<float>> SolveMembrane(const Grid<float>& stiffness, const Grid<float>& target,
                                  const MembraneOptions& options, const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GEOMORPHOLOGY_DIFFUSION_H_
