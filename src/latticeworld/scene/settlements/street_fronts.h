#ifndef LATTICEWORLD_SCENE_SETTLEMENTS_STREET_FRONTS_H_
#define LATTICEWORLD_SCENE_SETTLEMENTS_STREET_FRONTS_H_

#include <vector>

#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld {

// One edge of a street or road, smoothed, along land that is built up. The land lies to the left.
struct StreetFront {
  std::vector<WorldPoint> line;  // evenly spaced, about a metre apart
  double length_m = 0.0;         // at least kLeastFront_m

  // The place so far along the line, and the direction of the line there.
  struct Place {
    WorldPoint at;
    double heading_rad = 0.0;
  };
  Place At(double along_m) const;
};
inline constexpr double kLeastFront_m = 6.0;

// The edges of all paved ground, traced cell by cell from the north-west (streets that touch corner
// to corner hang together), where the weight of built-up land beside them is at least a half.
std::vector<StreetFront> StreetFrontsOf(const Terrain& terrain);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_SETTLEMENTS_STREET_FRONTS_H_
