#ifndef LATTICEWORLD_TERRAIN_PAVING_H_
#define LATTICEWORLD_TERRAIN_PAVING_H_

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld::internal {

// Evens the land [m] under roads along and across their course, and blends it into the land beside
// them. road: 1 on roads.
void SmoothRoads(const GridGeometry& geometry, const Grid<unsigned char>& road,
                 Grid<float>* land_m);

// Evens the land [m] under building land, level where a piece of it spans little relief.
void LevelPads(const GridGeometry& geometry, const Grid<unsigned char>& building,
               Grid<float>* land_m);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_PAVING_H_
