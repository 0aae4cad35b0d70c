#ifndef LATTICEWORLD_TESTS_RELIEF_SKETCH_ROUND_TRIP_H_
#define LATTICEWORLD_TESTS_RELIEF_SKETCH_ROUND_TRIP_H_

#include <cstdint>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/relief/sketch/sketch.h"

// Land, the sketch of it, and the land that is made of the sketch.
namespace latticeworld {

// Land that rivers made, (cells x cells) [m]: rolling ground, lifted unevenly while streams cut
// into it. The middle of a larger piece, so that its border is no coast.
Grid<float> ErodedLand(int cells, std::uint64_t seed);

// Of the pixels of strokes the shares that lie on the right side, valleys below and ridges above:
// of the nearest stroke of the other kind, and of the mean height around them (a Gaussian of 1/32
// of the side). The sketch has both kinds.
struct RightSides {
  double of_other = 0.0;
  double of_mean = 0.0;
};
RightSides MeasureStrokes(const Sketch& sketch, const Grid<float>& height);

// Pearson's, of all samples of two grids of one size.
double Correlation(const Grid<float>& a, const Grid<float>& b);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_RELIEF_SKETCH_ROUND_TRIP_H_
