#ifndef LATTICEWORLD_SCENE_SOLID_SET_H_
#define LATTICEWORLD_SCENE_SOLID_SET_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

// The solid circles that were placed so far, in a hash grid that grows as they come (AssetIndex is
// built once over a finished list).
class SolidSet {
 public:
  explicit SolidSet(double world_size_m);

  // True when a circle of that radius overlaps one that was added.
  bool Overlaps(WorldPoint point, double radius_m) const;
  void Add(WorldPoint point, double radius_m);

 private:
  struct Circle {
    double x_m, y_m, radius_m;
    std::int32_t next;  // in the same bucket; -1: none
  };
  int BucketOf(double coordinate_m) const;

  double half_size_m_;
  int buckets_;  // a side
  double largest_radius_m_ = 0.0;
  std::vector<std::int32_t> first_;  // of each bucket; -1: none
  std::vector<Circle> circles_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_SOLID_SET_H_
