#ifndef LATTICEWORLD_TERRAIN_CONES_H_
#define LATTICEWORLD_TERRAIN_CONES_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid.h"

namespace latticeworld::internal {

// Computes in place values(x) = min over y of values(y) + rise * |x - y|, distances in cells,
// infinity where y carries nothing. Two sweeps of a chamfer mask with knight's moves, whose
// distances are at most 2.8 % too long (Borgefors 1986, "Distance transformations in digital
// images").
void LowerCones(float rise_per_cell, Grid<float>* values);
// values(x) = max over y of values(y) - fall * |x - y|, minus infinity where y carries nothing.
void UpperCones(float fall_per_cell, Grid<float>* values);

// Lowers what stands more than its own rise_per_cell above a neighbour, and all that hangs on it,
// in one round of the same two sweeps.
void LimitSlope(const Grid<float>& rise_per_cell, Grid<float>* values);

// Returns for every cell the index of the nearest cell of the mask, by the same distances; -1 if
// the mask has none.
Grid<std::int32_t> NearestOf(const Grid<unsigned char>& mask);

// The same cones within a mask, along ways that never leave it: distances in king's moves of 1 and
// sqrt(2). Cells outside the mask are left alone.
void LowerConesWithin(const Grid<unsigned char>& mask, float rise_per_cell, Grid<float>* values);
void UpperConesWithin(const Grid<unsigned char>& mask, float fall_per_cell, Grid<float>* values);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_CONES_H_
