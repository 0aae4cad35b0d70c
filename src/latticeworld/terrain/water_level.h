#ifndef LATTICEWORLD_TERRAIN_WATER_LEVEL_H_
#define LATTICEWORLD_TERRAIN_WATER_LEVEL_H_

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/terrain/components.h"

namespace latticeworld::internal {

enum class WaterRule {
  kLevel,   // every water body is level, and neighbours agree as far as their gap asks
  kGraded,  // a long body that spans much relief falls along its course to its lowest shore
};

// The surface of each water body [m], NaN where dry: no higher than nearly all of its shore.
Grid<float> WaterLevels(const GridGeometry& geometry, const Components& bodies,
                        const Grid<float>& land_m, WaterRule rule, double bank_curvature_per_m);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_WATER_LEVEL_H_
