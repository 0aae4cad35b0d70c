#ifndef LATTICEWORLD_SIMULATION_AGENTS_BODIES_VEHICLE_GEOMETRY_H_
#define LATTICEWORLD_SIMULATION_AGENTS_BODIES_VEHICLE_GEOMETRY_H_

#include <cmath>

#include "latticeworld/species/species.h"
#include "latticeworld/species/vehicle_outline.h"

namespace latticeworld {

// Ackermann's geometry: all wheels roll around one point on the line of the rear axle. Angles of
// the front wheels, left positive, for a path of that curvature [1/m] of the rear axle's middle.
inline double LeftSteering(const VehicleDesign& design, double curvature) {
  return std::atan2(design.wheelbase_m * curvature, 1.0 - 0.5 * design.track_m * curvature);
}
inline double RightSteering(const VehicleDesign& design, double curvature) {
  return std::atan2(design.wheelbase_m * curvature, 1.0 + 0.5 * design.track_m * curvature);
}
// Returns the curvature of the tightest turn [1/m].
inline double MostCurvature(const VehicleDesign& design) {
  return std::tan(design.max_steering_rad) / design.wheelbase_m;
}
// Returns the steering angle of the inner wheel in the tightest turn [rad].
inline double InnerSteering(const VehicleDesign& design) {
  return LeftSteering(design, MostCurvature(design));
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_BODIES_VEHICLE_GEOMETRY_H_
