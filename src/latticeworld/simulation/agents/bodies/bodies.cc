#include "latticeworld/simulation/agents/bodies/bodies.h"

#include "latticeworld/simulation/agents/bodies/body_plans.h"

namespace latticeworld {
namespace {

// No blow or collision makes a body faster than this and twice its top speed; what falls from a
// tall tree or out of the air stays below it.
constexpr double kMostFall_mps = 40.0;

BodySpec PlanOf(const Species& species) {
  switch (species.plan) {
    case BodyPlan::kVehicle:
      return VehicleBody(species);
    case BodyPlan::kQuadruped:
      return QuadrupedBody(species);
    case BodyPlan::kBiped:
      return BipedBody(species);
    case BodyPlan::kGrazer:
      return GrazerBody(species);
    case BodyPlan::kFlyer:
      return FlyerBody(species);
    case BodyPlan::kSwimmer:
      return SwimmerBody(species);
  }
  return {};
}

std::vector<std::string> WheelNames(DriveKind drive) {
  if (drive == DriveKind::kDifferential) return {"left", "right", "castor"};
  return {"front_left", "front_right", "rear_left", "rear_right"};
}

}  // namespace

Eigen::Vector3d BoxInertia(double mass_kg, const Eigen::Vector3d& size_m) {
  const Eigen::Vector3d squares = size_m.cwiseAbs2();
  return mass_kg / 12.0 *
         Eigen::Vector3d(squares.y() + squares.z(), squares.x() + squares.z(),
                         squares.x() + squares.y());
}

BodyShape BoxShape(const Eigen::Vector3d& center_m, const Eigen::Vector3d& half_extents_m) {
  BodyShape shape;
  shape.form = ShapeForm::kBox;
  shape.center_m = center_m;
  shape.half_extents_m = half_extents_m;
  return shape;
}

void MakeBox(const Eigen::Vector3d& center_m, const Eigen::Vector3d& half_extents_m,
             BodySpec* body) {
  body->shapes = {BoxShape(center_m, half_extents_m)};
  for (const double x : {1.0, -1.0}) {
    for (const double y : {1.0, -1.0}) {
      for (const double z : {-1.0, 1.0}) {
        body->ground_samples.push_back(
            {center_m + Eigen::Vector3d(x, y, z).cwiseProduct(half_extents_m), 0.0});
      }
    }
  }
}

BodySpec BodyOf(const Species& species) {
  BodySpec body = PlanOf(species);
  body.grip = species.grip;
  body.max_speed_mps = kMostFall_mps + 2.0 * species.top_speed_mps;
  return body;
}

std::vector<JointName> JointsOf(const Species& species) {
  std::vector<JointName> joints;
  if (species.vehicle) {
    const std::vector<std::string> wheels = WheelNames(species.vehicle->drive);
    for (std::size_t i = 0; i < wheels.size(); ++i) {
      joints.push_back({wheels[i] + "_wheel", JointName::Kind::kWheel, i});
    }
    for (std::size_t i = 0; species.vehicle->drive == DriveKind::kAckermann && i < 2; ++i) {
      joints.push_back({wheels[i] + "_steering", JointName::Kind::kSteering, i});
    }
  }
  if (species.quadruped) {
    std::size_t link = 0;
    for (const char* leg : {"front_left", "front_right", "rear_left", "rear_right"}) {
      for (const char* joint : {"_hip_roll", "_hip_pitch", "_knee"}) {
        joints.push_back({std::string(leg) + joint, JointName::Kind::kLink, link++});
      }
    }
  }
  return joints;
}

}  // namespace latticeworld
