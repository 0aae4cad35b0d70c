#ifndef LATTICEWORLD_SCENE_FOOTPRINT_H_
#define LATTICEWORLD_SCENE_FOOTPRINT_H_

#include <array>

#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/scene/asset.h"

namespace latticeworld {

// The rectangle that a building covers. Its front looks along yaw.
struct Footprint {
  WorldPoint centre;
  double yaw_rad = 0.0;
  double half_length_m = 0.0;  // along yaw
  double half_width_m = 0.0;   // across, half the frontage

  double radius_m() const;  // of the circumscribed circle
  // A point by its distance from the centre along yaw and to the left of it.
  WorldPoint At(double along_m, double left_m) const;
  std::array<WorldPoint, 4> Corners() const;
};

Footprint FootprintOf(const Asset& building);

// Distance between the walls [m]; where the rectangles overlap minus the least way out.
double GapBetween(const Footprint& a, const Footprint& b);
// Distance to the wall [m], negative inside.
double GapTo(const Footprint& footprint, WorldPoint point);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_FOOTPRINT_H_
