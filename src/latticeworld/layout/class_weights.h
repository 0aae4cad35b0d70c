#ifndef LATTICEWORLD_LAYOUT_CLASS_WEIGHTS_H_
#define LATTICEWORLD_LAYOUT_CLASS_WEIGHTS_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

struct ClassWeight {
  char letter;
  Grid<float> weight;  // in [0, 1], (rows x cols) of the world; all classes sum to 1 in each cell
};

// Psi_L's result: per class of the vocabulary that occurs in the layout, how much a cell is of it.
struct ClassWeights {
  Vocabulary vocabulary = Vocabulary::kSuburb;
  std::vector<ClassWeight> classes;  // alphabetical by letter

  const Grid<float>* Find(char letter) const;  // nullptr when the class does not occur
  char DominantAt(CellIndex cell) const;       // the letter of the largest weight
};

struct DecodeOptions {
  double blend_width_m = 0.0;    // width of a blended border; 0: half a layout cell. [0, size / 8]
  double noise_amplitude = 0.5;  // border displacement in blend widths, [0, 1]
};

// Psi_L (Duan et al.): binary mask per class, stretched to the grid by nearest neighbour, borders
// displaced by noise and blended by a Gaussian. Beyond the method, rivers and roads whose cells
// touch with their corners stay connected. The same seed gives the same weights.
ClassWeights DecodeLayout(const SymbolicLayout& layout, const GridGeometry& geometry,
                          const DecodeOptions& options, std::uint64_t seed);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_CLASS_WEIGHTS_H_
