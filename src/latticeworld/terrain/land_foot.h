#ifndef LATTICEWORLD_TERRAIN_LAND_FOOT_H_
#define LATTICEWORLD_TERRAIN_LAND_FOOT_H_

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/terrain/water/water_bodies.h"

namespace latticeworld::internal {

// What the land rises from [m]: as high as the rivers that it drains to, and gently down, or up,
// from lakes that nothing drains; hills_m where there is no water. Without it rivers would run on
// dams above land that drains elsewhere. level_m: of the water, NaN where it is dry or not yet
// known.
Grid<float> FootOf(const GridGeometry& lattice, const WaterBodies& water,
                   const Grid<float>& level_m, const Grid<float>& hills_m);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_LAND_FOOT_H_
