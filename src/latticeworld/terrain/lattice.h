#ifndef LATTICEWORLD_TERRAIN_LATTICE_H_
#define LATTICEWORLD_TERRAIN_LATTICE_H_

#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld::internal {

// The lattice that a world's land is planned on: it depends on the world's size alone, so that one
// seed shows the same land at every resolution, and whatever looks at more than one cell at a time
// costs the same. Only what each cell needs for itself is done on the world's own grid.
GridGeometry LatticeOf(const GridGeometry& world);

// Cells of the lattice a cell of the layout.
double LatticeCellsPerLayoutCell(const GridGeometry& lattice);

// Reads a grid at the cell centres of another one over the same area, row by row: no memory but a
// line. The source is no finer than what is read.
class RowSampler {
 public:
  enum class Kernel {
    // Cubic B-spline: smooth to the second derivative, never beyond its values, and weights that
    // sum to 1 still do. It rounds what is narrower than two cells.
    kSmooth,
    // Catmull-Rom (Keys 1981, "Cubic convolution interpolation"): goes through the samples.
    kThrough,
  };
  // source: must outlive the sampler. cells: a side of the grid that is read.
  RowSampler(const Grid<float>& source, int cells, Kernel kernel);

  // values: one row. scratch: kept from call to call, one a thread.
  void Row(int row, std::vector<float>* scratch, float* values) const;

 private:
  struct Taps {
    int first = 0;  // may lie outside: the edge continues
    float weight[4] = {};
  };
  static std::vector<Taps> MakeTaps(int source_cells, int cells, Kernel kernel);

  const Grid<float>& source_;
  bool copies_;  // the same cells, to be gone through
  std::vector<Taps> rows_;
  std::vector<Taps> cols_;
};

// The coefficients of the cubic B-spline that goes through the values (Unser, Aldroubi and Eden
// 1993, "B-spline signal processing"): RowSampler's smooth kernel reads the values back from them,
// where it would round them off. Mirrored at the edges; at least 16 cells a side.
Grid<float> SplineCoefficients(Grid<float> values);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_LATTICE_H_
