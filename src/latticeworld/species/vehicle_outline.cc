#include "latticeworld/species/vehicle_outline.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

// Returns the distance to the farthest corner of a wheel that points ahead, its middle at (x, y)
// [m].
double ReachOfWheel(const VehicleDesign& design, double x_m, double y_m) {
  return std::hypot(std::abs(x_m) + design.wheel_radius_m, y_m + 0.5 * design.wheel_width_m);
}

// The same of one that turns, whichever way it points.
double ReachOfSteeredWheel(const VehicleDesign& design, double x_m, double y_m) {
  return std::hypot(x_m, y_m) + std::hypot(design.wheel_radius_m, 0.5 * design.wheel_width_m);
}

}  // namespace

double CircumscribedRadius(const VehicleDesign& design) {
  const double chassis_m = 0.5 * std::hypot(design.chassis_length_m, design.chassis_width_m);
  const double half_track_m = 0.5 * design.track_m, half_base_m = 0.5 * design.wheelbase_m;
  if (design.drive == DriveKind::kDifferential) {
    const double axle_m = DifferentialAxle(design);
    return std::max({chassis_m, ReachOfWheel(design, axle_m, half_track_m),
                     ReachOfSteeredWheel(design, axle_m - design.wheelbase_m, 0.0)});
  }
  const double wheels_m = design.drive == DriveKind::kAckermann
                              ? ReachOfSteeredWheel(design, half_base_m, half_track_m)
                              : ReachOfWheel(design, half_base_m, half_track_m);
  return std::max(chassis_m, wheels_m);
}

}  // namespace latticeworld
