#ifndef LATTICEWORLD_TERRAIN_LAND_H_
#define LATTICEWORLD_TERRAIN_LAND_H_

#include <cstdint>

#include "latticeworld/common/progress.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/layout/class_weights.h"
#include "latticeworld/relief/relief.h"
#include "latticeworld/terrain/forms/relief_forms.h"
#include "latticeworld/terrain/water/water_bodies.h"

namespace latticeworld::internal {

// The land of a fixed-height scene and the water in it, on the lattice.
struct ShapedLand {
  Grid<float> height_m;
  Grid<float> water_level_m;  // NaN where dry
};

// Landscape evolution with the layout's water as base level: uplift and erodibility of each class,
// stream power until valleys drain into rivers, lakes and the sea, slides where it is too steep,
// and creep on soft ground. Closed lakes get the level of the land that they lie in. What words say
// of the land's form rises with it, or is laid into it. Errors: CANCELLED.
Result<ShapedLand> ShapeLand(const GridGeometry& lattice, const SmoothedMasks& masks,
                             const WaterBodies& water, const ReliefForms& forms, std::uint64_t seed,
                             const Progress& progress);

// Fills the hollows of dry land [m] that creep and banks have closed, so that all of it drains to
// water or over the edge; or to where `hollow` is 1, the bottoms of what was asked to be closed.
void FillHollows(double cell_m, const WaterBodies& water, const Grid<float>& level_m,
                 const Grid<unsigned char>& hollow, Grid<float>* land_m);

// The user's land [m], on its own grid where that has fewer than cells x cells, else on such a one.
// Where its heights come in steps the terraces are smoothed, each height by at most half a step:
// what the picture's depth left open.
Grid<float> ReliefLand(const Relief& relief, int cells);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_LAND_H_
