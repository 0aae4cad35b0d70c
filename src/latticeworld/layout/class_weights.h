#ifndef LATTICEWORLD_LAYOUT_CLASS_WEIGHTS_H_
#define LATTICEWORLD_LAYOUT_CLASS_WEIGHTS_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/layout/claims/crossings.h"
#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/layout/weight_grid.h"

namespace latticeworld {

struct ClassWeight {
  char letter;
  WeightGrid weight;  // (rows x cols) of the world; all classes sum to 1 in each cell
};

// Psi_L's result: per class of the vocabulary that occurs in the layout, how much a cell is of it.
struct ClassWeights {
  Vocabulary vocabulary = Vocabulary::kSuburb;
  std::vector<ClassWeight> classes;  // alphabetical by letter

  const WeightGrid* Find(char letter) const;  // nullptr when the class does not occur
  char DominantAt(CellIndex cell) const;      // the letter of the largest weight
};

struct DecodeOptions {
  double blend_width_m = 0.0;    // width of a blended border; 0: half a layout cell. [0, size / 8]
  double noise_amplitude = 0.5;  // border displacement in blend widths, [0, 1]
  bool fords = false;            // roads ford narrow rivers; else below roads over water is water
};

// The masks of Psi_L (DecodeLayout) as they come out of the blur.
struct SmoothedMask {
  char letter;
  Grid<float>
      weight;  // in [0, 1], (rows x cols); all classes sum to 1 in each cell but for rounding
};
struct SmoothedMasks {
  Vocabulary vocabulary = Vocabulary::kSuburb;
  std::vector<SmoothedMask> classes;  // alphabetical by letter
};

// Rounds so that all classes still sum to 1 in each cell.
ClassWeights ToWeights(const SmoothedMasks& masks);

// Psi_L, and what a terrain has to know of rivers and roads. All grids are (rows x cols).
struct DecodedLayout {
  SmoothedMasks masks;
  Grid<Crossing> crossing;          // of roads, where they meet water
  Grid<float> to_road_center_rows;  // from near a road to its centre line [cells]; 0 far from roads
  Grid<float> to_road_center_cols;  // and within areas of road
};

// Psi_L (Duan et al.): binary mask per class, stretched to the grid by nearest neighbour, borders
// displaced by noise and blended by a Gaussian. Beyond the method, rivers and roads are drawn as
// curves along the middles of their cells: they stay connected where cells touch with their corners
// only, rivers meander, and beside them lies what lies beside their cells. The same seed gives the
// same masks.
DecodedLayout DecodeLayout(const SymbolicLayout& layout, const GridGeometry& geometry,
                           const DecodeOptions& options, std::uint64_t seed);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_CLASS_WEIGHTS_H_
