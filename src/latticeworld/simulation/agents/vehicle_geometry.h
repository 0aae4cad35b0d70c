#ifndef LATTICEWORLD_SIMULATION_AGENTS_VEHICLE_GEOMETRY_H_
#define LATTICEWORLD_SIMULATION_AGENTS_VEHICLE_GEOMETRY_H_

#include <cmath>

#include "latticeworld/species/species.h"

namespace latticeworld {

// The middle of a differential vehicle's mass lies a quarter of the wheelbase behind its axle, so
// that it stands on the castor: x of the axle in base_link [m].
inline double DifferentialAxle(const VehicleDesign& design) { return 0.25 * design.wheelbase_m; }

// Ackermann's geometry: all wheels roll around one point on the line of the rear axle. Angles of
// the front wheels, left positive, for a path of that curvature [1/m] of the rear axle's middle.
inline double LeftSteering(const VehicleDesign& design, double curvature) {
  return std::atan2(design.wheelbase_m * curvature, 1.0 - 0.5 * design.track_m * curvature);
}
inline double RightSteering(const VehicleDesign& design, double curvature) {
  return std::atan2(design.wheelbase_m * curvature, 1.0 + 0.5 * design.track_m * curvature);
}
// Of the tightest turn [1/m].
inline double MostCurvature(const VehicleDesign& design) {
  return std::tan(design.max_steering_rad) / design.wheelbase_m;
}
// Of the inner wheel in it [rad].
inline double InnerSteering(const VehicleDesign& design) {
  return LeftSteering(design, MostCurvature(design));
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_VEHICLE_GEOMETRY_H_
