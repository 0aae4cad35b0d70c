#include <cmath>

#include "latticeworld/simulation/agents/bodies/body_plans.h"
#include "latticeworld/simulation/agents/bodies/vehicle_geometry.h"

namespace latticeworld {
namespace {

constexpr double kCastorSideGrip = 0.02;  // it swivels

WheelSpec WheelAt(const VehicleDesign& design, double x_m, double y_m) {
  WheelSpec wheel;
  wheel.center_m = {x_m, y_m, design.wheel_radius_m};
  wheel.radius_m = design.wheel_radius_m;
  wheel.mass_kg = design.wheel_mass_kg;
  wheel.max_torque_nm = design.max_torque_nm;
  wheel.width_m = design.wheel_width_m;
  wheel.side_grip = design.drive == DriveKind::kSkidSteer ? kSkidSideGrip : kTyreSideGrip;
  wheel.spring_npm = design.spring_npm;
  wheel.damper_nspm = design.damper_nspm;
  wheel.travel_m = design.travel_m;
  return wheel;
}

std::vector<WheelSpec> Wheels(const VehicleDesign& design) {
  const double half_track_m = 0.5 * design.track_m;
  std::vector<WheelSpec> wheels;
  if (design.drive == DriveKind::kDifferential) {
    const double axle_m = DifferentialAxle(design);
    wheels.push_back(WheelAt(design, axle_m, half_track_m));
    wheels.push_back(WheelAt(design, axle_m, -half_track_m));
    WheelSpec castor = WheelAt(design, axle_m - design.wheelbase_m, 0.0);
    castor.max_torque_nm = 0.0;
    castor.side_grip = kCastorSideGrip;
    wheels.push_back(castor);
    return wheels;
  }
  const bool steered = design.drive == DriveKind::kAckermann;
  for (const double x_m : {0.5 * design.wheelbase_m, -0.5 * design.wheelbase_m}) {
    for (const double y_m : {half_track_m, -half_track_m}) {
      WheelSpec wheel = WheelAt(design, x_m, y_m);
      if (steered && x_m > 0.0) {
        wheel.max_torque_nm = 0.0;
        wheel.max_steering_rad = InnerSteering(design);
      }
      wheels.push_back(wheel);
    }
  }
  return wheels;
}

}  // namespace

BodySpec VehicleBody(const Species& species) {
  const VehicleDesign& design = *species.vehicle;
  BodySpec body;
  body.wheels = Wheels(design);
  body.mass_kg = species.mass_kg - static_cast<double>(body.wheels.size()) * design.wheel_mass_kg;
  const Eigen::Vector3d size_m(design.chassis_length_m, design.chassis_width_m,
                               species.height_m - design.ground_clearance_m);
  body.inertia_kgm2 = BoxInertia(body.mass_kg, size_m);
  body.center_height_m = design.center_height_m;
  const Eigen::Vector3d half_m = 0.5 * size_m;
  const Eigen::Vector3d center_m(0.0, 0.0, design.ground_clearance_m + half_m.z());
  MakeBox(center_m, half_m, &body);
  return body;
}

}  // namespace latticeworld
