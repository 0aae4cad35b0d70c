#ifndef LATTICEWORLD_SCENE_SETTLEMENTS_SETTLEMENT_MAP_H_
#define LATTICEWORLD_SCENE_SETTLEMENTS_SETTLEMENT_MAP_H_

#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld {

// A connected piece of built-up land, the streets and roads through it included.
struct Settlement {
  double area_m2 = 0.0;   // built-up
  double axis_rad = 0.0;  // of its longest extent, (-pi / 2, pi / 2]; 0 where none stands out
  WorldPoint heart;       // near its middle, as far inside as that goes
  double inner_m = 0.0;   // largest distance to its border
  double reach_m = 0.0;   // from the heart to its farthest cell
};

// The settlements of a world, on a grid of at most 1024 x 1024 cells.
class SettlementMap {
 public:
  // terrain: of the suburb vocabulary, with built-up land.
  explicit SettlementMap(const Terrain& terrain);

  const std::vector<Settlement>& settlements() const { return settlements_; }
  int At(WorldPoint point) const;             // index of the settlement, -1: none
  double ToBorder_m(WorldPoint point) const;  // from within a settlement, 0 outside
  double ToField_m(WorldPoint point) const;   // farmland; infinity without any
  double cell_m() const { return geometry_.resolution_m(); }

 private:
  GridGeometry geometry_;
  Grid<int> label_;
  Grid<float> to_border_;  // [cells]
  Grid<float> to_field_;   // [cells]
  std::vector<Settlement> settlements_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_SETTLEMENTS_SETTLEMENT_MAP_H_
