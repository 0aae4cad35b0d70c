#ifndef LATTICEWORLD_SCENE_CLASS_AREAS_H_
#define LATTICEWORLD_SCENE_CLASS_AREAS_H_

#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/layout/weight_grid.h"

namespace latticeworld {

// The connected areas (4 neighbours) of one class, where its weight is at least a half, on a coarse
// grid of at most 64 x 64 cells. Each has a main direction, the principal axis of its cells.
class ClassAreas {
 public:
  struct Area {
    WorldPoint centre;  // mean of its cells
    double direction_rad =
        0.0;               // of its longest extent, (-pi / 2, pi / 2]; 0 where none stands out
    double reach_m = 0.0;  // from the centre to the outermost point that AreaAt gives to it
  };

  // weight: (rows x cols) of the geometry, in [0, 1].
  ClassAreas(const GridGeometry& geometry, const WeightGrid& weight);

  const std::vector<Area>& areas() const { return areas_; }
  // Index of the area at the point, or of one in a neighbouring coarse cell (borders are finer than
  // the coarse grid); -1: none.
  int AreaAt(WorldPoint point) const;

 private:
  GridGeometry coarse_;
  Grid<int> label_;  // -1: no area
  std::vector<Area> areas_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_CLASS_AREAS_H_
