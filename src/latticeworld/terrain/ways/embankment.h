#ifndef LATTICEWORLD_TERRAIN_WAYS_EMBANKMENT_H_
#define LATTICEWORLD_TERRAIN_WAYS_EMBANKMENT_H_

#include "latticeworld/geometry/grid.h"

namespace latticeworld::internal {

// Lays what is built into the land [m] by cut and fill: its own heights where the mask is 1 and on
// shoulders of about a cell, and from there on land that rises and falls no steeper than
// `rise_per_cell` [m] from them; where a cut or fill is higher than 3 m, twice as steeply, so that
// it does not eat the hill that it goes through. share: gets how much of each cell is shaped, in
// [0, 1].
void LayInto(const Grid<unsigned char>& mask, const Grid<float>& built_m, float rise_per_cell,
             Grid<float>* land_m, Grid<float>* share);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_WAYS_EMBANKMENT_H_
