#ifndef LATTICEWORLD_MAPPING_TRAVERSABILITY_H_
#define LATTICEWORLD_MAPPING_TRAVERSABILITY_H_

#include <array>
#include <cstdint>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/scene/scene_changes.h"

namespace latticeworld {

struct Scene;

// The robot that a map is made for. The usual radius is that of the built-in wheeled robot.
struct RobotLimits {
  double radius_m = 0.4;          // 0: obstacles are not inflated
  double max_slope_rad = 0.5236;  // 30 degrees
  // Height difference between neighbouring cells that it can climb. A difference that a slope of
  // max_slope makes over the same distance is no step, so that coarse grids do not close slopes.
  double max_step_m = 0.25;
  double max_fording_depth_m = 0.2;
  // Height that has to be free above the ground that it stands on: where a crown hangs lower, over
  // any part of the robot, it cannot go. 0: crowns are no matter.
  double clearance_m = 0.5;
  // Bridges that carry less are no way for it.
  double mass_kg = 50.0;
  // What it pushes with, times the friction of the ground: slopes steeper than ClimbableSlope
  // (terrain/surface.h) slip away below it, however strong it is.
  double grip = 1.0;
  bool on_wheels = true;
};

// All of them legal: RobotLimits finite, none below 0, max_slope_rad in (0, pi/2), grip above 0.
// changes: trees that fell, assets that went, props that moved and what weather made of the
// ground since the world began; a fallen trunk blocks as it lies, and so does its crown where
// clearance_m is above 0. Crates, loose stones, posts and gates' panels block as they stand;
// bridges that carry the robot are level open ground in their middle and block it beside that;
// others block it where they leave it no room below (prop_boxes.h). threads: at most; 0: as many
// as the machine has cores; the result is the same.

// (rows x cols) of the scene's geometry, in [0, 1]: 0 impassable, 1 level open ground. Slopes and
// shallow water lie between, by their shares of the steepest slope that the robot climbs on that
// surface and of max_fording_depth. It is 0 exactly
// where BuildOccupancy with the same limits is 100.
Grid<float> BuildTraversability(const Scene& scene, const RobotLimits& limits,
                                const SceneChanges& changes = {}, int threads = 0);

// (rows x cols), row 0 north: 0 free .. 100 occupied; graded costs on slopes: a slope that the
// robot can climb stays below 50. Solid assets (grown by the robot's radius), low crowns, deep
// water, steps and too steep ground are 100.
Grid<std::int8_t> BuildOccupancy(const Scene& scene, const RobotLimits& limits,
                                 const SceneChanges& changes = {}, int threads = 0);

// What an occupancy map says of ground that a robot can cross with effort.
enum class MapValues : std::uint8_t {
  kGraded,  // as BuildOccupancy has it
  kTrinary  // free 0, occupied 100, unknown -1: some programs take what is between for unknown
};
constexpr std::array<EnumName<MapValues>, 2> EnumNames(MapValues) {
  return {{{MapValues::kGraded, "graded"}, {MapValues::kTrinary, "trinary"}}};
}

// The same map with such values: in the trinary one what is known and below 100 is free.
Grid<std::int8_t> WithValues(Grid<std::int8_t> occupancy, MapValues values);

// Euclidean distance [m] between the centre of each cell and that of the nearest occupied one (100
// of BuildOccupancy): 0 on those, infinity everywhere when there is none.
Grid<float> BuildDistanceField(const Grid<std::int8_t>& occupancy, double resolution_m);

// Slope [rad] of the ground at cell centres, central differences over the triangulation's vertices
// (one-sided at the world's edge).
Grid<float> BuildSlope(const Scene& scene, int threads = 0);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_TRAVERSABILITY_H_
