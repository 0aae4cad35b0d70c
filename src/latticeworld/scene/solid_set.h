#ifndef LATTICEWORLD_SCENE_SOLID_SET_H_
#define LATTICEWORLD_SCENE_SOLID_SET_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

// The solid circles that were placed so far, in hash grids that grow as they come (AssetIndex is
// built once over a finished list). Small and large circles lie in grids of their own, so that one
// house does not make every tree look far around.
class SolidSet {
 public:
  explicit SolidSet(double world_size_m);

  // True when a circle of that radius overlaps one that was added.
  bool Overlaps(WorldPoint point, double radius_m) const;
  // The same with the large ones alone: buildings and boulders.
  bool OverlapsLarge(WorldPoint point, double radius_m) const;
  void Add(WorldPoint point, double radius_m);

 private:
  struct Circle {
    float x_m, y_m, radius_m;
    std::int32_t next;  // in the same bucket; -1: none
  };
  struct Layer {
    Layer(double world_size_m, double the_bucket_m);
    int BucketOf(double coordinate_m) const;
    bool Overlaps(WorldPoint point, double radius_m) const;
    void Add(WorldPoint point, double radius_m);

    double half_size_m, bucket_m;
    int buckets;  // a side
    double largest_radius_m = 0.0;
    std::vector<std::int32_t> first;  // of each bucket; -1: none
    std::vector<Circle> circles;
  };

  Layer small_, large_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_SOLID_SET_H_
