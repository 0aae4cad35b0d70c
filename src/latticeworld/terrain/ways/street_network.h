#ifndef LATTICEWORLD_TERRAIN_WAYS_STREET_NETWORK_H_
#define LATTICEWORLD_TERRAIN_WAYS_STREET_NETWORK_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld::internal {

// A local street: its centre line, in order, and how wide it is paved.
struct Street {
  std::vector<WorldPoint> line;  // at least two points, a few metres apart
  double width_m = 4.0;
};

// The streets that were laid so far, to be asked what lies near a place.
class StreetNetwork {
 public:
  explicit StreetNetwork(double world_size_m);

  // The index of the street.
  int Add(Street street);
  const std::vector<Street>& streets() const { return streets_; }

  struct Node {
    WorldPoint at;
    double heading_rad;  // of the street there
    int street;
    int point;  // of its line
  };
  // Calls visit(node, distance_m) for every point of a street within radius_m.
  template <typename Visit>
  void ForEachNear(WorldPoint place, double radius_m, Visit&& visit) const;

  // Whether a street that runs within 40 degrees of the heading passes within radius_m, ahead of or
  // abreast of `place`. What begins at the same place and leads the other way is behind.
  bool HasParallel(WorldPoint place, double heading_rad, double radius_m) const;

 private:
  int BucketOf(double coordinate_m) const;

  double half_size_m_;
  double bucket_m_;
  int buckets_;                     // a side
  Grid<std::int32_t> first_;        // node of each bucket, -1: none
  std::vector<std::int32_t> next_;  // of each node in its bucket
  std::vector<Node> nodes_;
  std::vector<Street> streets_;
};

// The acute angle between two lines [rad], in [0, pi / 2].
double AngleBetweenLines(double a_rad, double b_rad);

double DistanceBetween(WorldPoint a, WorldPoint b);

template <typename Visit>
void StreetNetwork::ForEachNear(WorldPoint place, double radius_m, Visit&& visit) const {
  const int row_end = BucketOf(place.y_m + radius_m), col_end = BucketOf(place.x_m + radius_m);
  for (int row = BucketOf(place.y_m - radius_m); row <= row_end; ++row) {
    for (int col = BucketOf(place.x_m - radius_m); col <= col_end; ++col) {
      for (std::int32_t i = first_(row, col); i >= 0; i = next_[i]) {
        const double distance_m = DistanceBetween(nodes_[i].at, place);
        if (distance_m <= radius_m) visit(nodes_[i], distance_m);
      }
    }
  }
}

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_WAYS_STREET_NETWORK_H_
