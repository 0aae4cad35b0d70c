#ifndef LATTICEWORLD_TERRAIN_WATER_WATER_LEVEL_H_
#define LATTICEWORLD_TERRAIN_WATER_WATER_LEVEL_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/terrain/water/water_bodies.h"

namespace latticeworld::internal {

// Returns where the water of each body leaves it: into the sea if the body has any, else over the
// world's edge where the land [m] is lowest, else in its lowest lake or its lowest cell, where it
// stays.
std::vector<std::int32_t> OutletsOf(const WaterBodies& water, const Grid<float>& land_m);

// Returns for every wet cell the least sum of `cost` over ways through water to an outlet, infinity
// elsewhere: by Dijkstra 1959, ties to the smaller index. cost: of a step of one cell. Still water
// costs nothing, so that it has one distance.
Grid<float> FlowDistance(const WaterBodies& water, const std::vector<std::int32_t>& outlets,
                         const Grid<float>& cost);

// The surface of water in a land that is still to be shaped around it [m], NaN where dry.
//
// A river's surface is the base level of its body plus `rise_m`, a flow distance whose cost is the
// fall of the river; lakes and the sea are level.
class ShapedLevels {
 public:
  // rise_m: infinity where dry.
  ShapedLevels(const WaterBodies& water, Grid<float> rise_m);

  // Base levels of the bodies whose water runs off: the sea lies at 0, rivers that leave the world
  // below the land there. land_m: before water has shaped it.
  void SetOpenBases(const std::vector<std::int32_t>& outlets, const Grid<float>& land_m,
                    double incision_m);
  // Sets the base levels of the other bodies: lower than nearly all of their shore.
  void SetClosedBases(const Grid<float>& land_m, double incision_m);
  // Lowers bodies that lie more than slope * distance above another one, slope per cell.
  void Reconcile(double slope_m_per_cell);

  bool IsSet(std::int32_t body) const { return base_m_[body] == base_m_[body]; }
  Grid<float> Levels() const;

 private:
  const WaterBodies& water_;
  Grid<float> rise_m_;
  std::vector<float> base_m_;  // NaN: not yet known
};

// The surface of water in a given land [m], NaN where dry. Lakes lie below nearly all of their
// shore, the sea has one level, and rivers fall along their course, never above their banks but
// where they are lower than what flows into them or falls steeper than `steepest` [m/m].
struct GradedRule {
  double incision_m = 0.4;       // water lies this much below its shore
  double steepest = 0.3;         // fall of a river [m/m]
  double neighbour_slope = 0.3;  // of the land between two bodies, at most
};
Grid<float> GradedLevels(const GridGeometry& geometry, const WaterBodies& water,
                         const Grid<float>& land_m, const GradedRule& rule);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_WATER_WATER_LEVEL_H_
