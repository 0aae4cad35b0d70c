#ifndef LATTICEWORLD_NAVIGATION_NAVIGABLE_MAP_H_
#define LATTICEWORLD_NAVIGATION_NAVIGABLE_MAP_H_

#include <cstdint>

#include "latticeworld/common/status.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/geometry/height_field.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/scene/scene_changes.h"

namespace latticeworld {

struct Scene;

// Says where one robot's centre can be, and how high the ground is there, or the deck that carries
// it.
struct NavigableMap {
  HeightField ground;
  Grid<std::uint8_t> free;  // (rows x cols) of ground.geometry(); 1: it can be there

  const GridGeometry& geometry() const { return ground.geometry(); }
  bool IsFree(WorldPoint point) const {
    return geometry().Contains(point) && free[geometry().CellAt(point)] != 0;
  }
};

// Free is what the traversability map of the robot has above 0. Deterministic; threads: 0: as many
// as cores.
NavigableMap BuildNavigableMap(const Scene& scene, const RobotLimits& limits,
                               const SceneChanges& changes = {}, int threads = 0);

// OK for finite places inside; else INVALID_ARGUMENT or OUT_OF_RANGE beginning with `what` ("the
// goal").
Status CheckInside(const GridGeometry& geometry, WorldPoint point, const char* what);

// A straight line in plan, measured on the surface.
struct SurfaceLine {
  bool is_free = false;  // the robot can go along it; the rest counts only then
  double length_m = 0.0;
  double climb_m = 0.0;  // sum of all that it goes up
};
SurfaceLine MeasureLine(const NavigableMap& map, WorldPoint from, WorldPoint to);

}  // namespace latticeworld

#endif  // LATTICEWORLD_NAVIGATION_NAVIGABLE_MAP_H_
