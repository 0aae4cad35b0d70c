#ifndef LATTICEWORLD_TERRAIN_WAYS_BENCHES_H_
#define LATTICEWORLD_TERRAIN_WAYS_BENCHES_H_

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/terrain/water/banks.h"

namespace latticeworld::internal {

// Lays fields on slopes [m] in level benches with soft steps between them that follow the contours.
// weight: of farmland, in [0, 1].
void TerraceFields(const GridGeometry& lattice, const Grid<float>& weight, Grid<float>* land_m);

// Levels building land [m]: a piece of it wholly where it spans little relief, else in terraces as
// wide as a block, neither above nor below what the banks of water allow. building: 1 on building
// land. share: gets how much of each cell is shaped, in [0, 1].
void LevelPads(const GridGeometry& lattice, const Grid<unsigned char>& building, const Banks& banks,
               Grid<float>* land_m, Grid<float>* share);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_WAYS_BENCHES_H_
