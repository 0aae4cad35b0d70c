#ifndef LATTICEWORLD_TERRAIN_WATER_H_
#define LATTICEWORLD_TERRAIN_WATER_H_

#include <utility>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/terrain/water_level.h"

namespace latticeworld::internal {

// How water sits in the land. In this order: Flood, ShapeBanks, whatever else shapes dry land,
// Settle.
class WaterShaper {
 public:
  // wet: 1 where water stands. curvature: banks rise as curvature * distance^2 [1/m].
  WaterShaper(const GridGeometry& geometry, Grid<unsigned char> wet, WaterRule rule);

  // Finds the levels from the land [m] and fits the banks to them: no higher than a valley's side,
  // no lower than a dam's.
  void ShapeBanks(Grid<float>* land_m);

  // Fits banks anew, steeper ones at most where something was built in them, digs the beds and
  // closes the shores: every wet cell lies below its water, every dry cell beside water above it.
  void Settle(Grid<float>* land_m) const;

  // Surface of the water [m], NaN where dry; after ShapeBanks.
  const Grid<float>& level_m() const { return level_m_; }
  Grid<float> TakeLevel() { return std::move(level_m_); }

 private:
  GridGeometry geometry_;
  Grid<unsigned char> wet_;
  WaterRule rule_;
  double bank_curvature_per_m_;
  bool any_ = false;
  Grid<float> level_m_;
  // How high dry land lies [m]: at most the valley and at least the dam, which meet at the shore.
  Grid<float> valley_m_;
  Grid<float> dam_m_;
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_WATER_H_
