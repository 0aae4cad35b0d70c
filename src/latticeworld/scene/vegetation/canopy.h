#ifndef LATTICEWORLD_SCENE_VEGETATION_CANOPY_H_
#define LATTICEWORLD_SCENE_VEGETATION_CANOPY_H_

#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/scene/asset.h"

namespace latticeworld {

// How much of the sky the crowns of trees hide, smoothed over about ten metres, on a grid of at
// most 256 x 256 cells: 1 - exp(-area of crowns over area of ground), as crowns that stand
// independently of each other cover it.
class Canopy {
 public:
  // No trees yet.
  explicit Canopy(double world_size_m);
  // The trees among the assets.
  Canopy(double world_size_m, const std::vector<Asset>& assets, int threads);

  double At(WorldPoint point) const { return cover_[geometry_.CellAt(point)]; }  // [0, 1]

 private:
  GridGeometry geometry_;
  Grid<float> cover_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_VEGETATION_CANOPY_H_
