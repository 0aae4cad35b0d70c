#ifndef LATTICEWORLD_MAPPING_OCTREE_GROUND_VOXELS_H_
#define LATTICEWORLD_MAPPING_OCTREE_GROUND_VOXELS_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/height_field.h"
#include "latticeworld/mapping/octree/voxel_box.h"

namespace latticeworld {

// The voxel that holds HeightAt(centre) of every column of a box, to the bit, row by row: where
// the columns' centres fall between the vertices is worked out once.
class GroundVoxels {
 public:
  // ground: kept by reference. columns: its x and y.
  GroundVoxels(const HeightField& ground, double voxel_m, const VoxelBox& columns);

  // The columns x_low..x_high (both included, within the box) of row y.
  void SampleRow(int y, int x_low, int x_high, std::int16_t* surface) const;

 private:
  // A line of column centres lies between vertices `vertex` and `vertex` + 1, at `share` of the
  // way.
  struct Place {
    int vertex;
    double share;
  };

  const HeightField& ground_;
  double voxels_per_m_;
  int x_low_, y_low_;
  std::vector<Place> x_places_;  // eastward
  std::vector<Place> y_places_;  // northward; shares grow southward
  int on_vertices_ = 0;          // so many x_places_ from the first are neighbouring vertices
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_OCTREE_GROUND_VOXELS_H_
