#ifndef LATTICEWORLD_GEOMORPHOLOGY_REALISM_SPECTRUM_H_
#define LATTICEWORLD_GEOMORPHOLOGY_REALISM_SPECTRUM_H_

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geomorphology/realism.h"

namespace latticeworld {

// A part of a grid.
struct Window {
  int row = 0;
  int col = 0;
  int rows = 0;  // 0: there is none
  int cols = 0;
};

// The whole grid when at most a twentieth of it is not dry, else the largest square of at least 64
// cells a side of which no more is (to a tenth of its side; the northernmost, then westernmost
// one).
Window DryWindow(const Grid<unsigned char>& dry);

// The part of MeasureRealism that looks at the power spectrum. NaN where the window is flat.
void MeasureSpectra(const Grid<float>& height_m, double resolution_m, const Window& window,
                    int threads, RealismMeasures* measures);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GEOMORPHOLOGY_REALISM_SPECTRUM_H_
