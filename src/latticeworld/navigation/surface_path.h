#ifndef LATTICEWORLD_NAVIGATION_SURFACE_PATH_H_
#define LATTICEWORLD_NAVIGATION_SURFACE_PATH_H_

#include <Eigen/Core>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

struct DistanceField;
struct NavigableMap;

struct SurfacePath {
  std::vector<Eigen::Vector3d> points_m;  // on the ground, frame map; start and goal among them
  double length_m = 0.0;                  // of its legs, measured on the surface
  double climb_m = 0.0;                   // sum of all that it goes up
};

// The way from `start` down the field to its goal, pulled straight where that makes it no longer.
// Errors: NOT_FOUND (no way within the field), OUT_OF_RANGE, INVALID_ARGUMENT.
Result<SurfacePath> PathDown(const NavigableMap& map, const DistanceField& field, WorldPoint start);

}  // namespace latticeworld

#endif  // LATTICEWORLD_NAVIGATION_SURFACE_PATH_H_
