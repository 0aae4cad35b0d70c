#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/bodies/drives.h"
#include "latticeworld/simulation/agents/bodies/vehicle_geometry.h"

namespace latticeworld {
namespace {

constexpr double kSlowest_mps = 0.05;  // of an Ackermann vehicle that is told to turn

struct WheelCommand {
  double rate_radps = 0.0;
  double steer_rad = 0.0;
};

// Returns the commands in the order of the body's wheels.
std::array<WheelCommand, 4> CommandsFor(const VehicleDesign& design,
                                        const VelocityCommand& wanted) {
  const double speed_mps = wanted.linear_mps.x();
  const double turn_mps = 0.5 * design.track_m * wanted.yaw_rate_radps;
  const double left = (speed_mps - turn_mps) / design.wheel_radius_m;
  const double right = (speed_mps + turn_mps) / design.wheel_radius_m;
  if (design.drive == DriveKind::kDifferential) return {{{left}, {right}, {}, {}}};
  if (design.drive == DriveKind::kSkidSteer) return {{{left}, {right}, {left}, {right}}};
  // It cannot turn on the spot: standing, its wheels stay straight.
  double curvature = 0.0;
  if (std::abs(speed_mps) > kSlowest_mps) {
    const double most = MostCurvature(design);
    curvature = std::clamp(wanted.yaw_rate_radps / speed_mps, -most, most);
  }
  const double inner = 0.5 * design.track_m * curvature;
  return {{{0.0, LeftSteering(design, curvature)},
           {0.0, RightSteering(design, curvature)},
           {speed_mps * (1.0 - inner) / design.wheel_radius_m},
           {speed_mps * (1.0 + inner) / design.wheel_radius_m}}};
}

}  // namespace

void DriveWheels(const Agent& agent, PhysicsWorld* physics) {
  const VehicleDesign& design = *agent.species->vehicle;
  const std::size_t count = design.drive == DriveKind::kDifferential ? 3 : 4;
  std::array<WheelCommand, 4> commands = CommandsFor(design, agent.driven);
  if (agent.able()) {
    for (const auto& [joint, target] : agent.joint_targets) {
      if (joint < count) {
        if (target.mode == JointMode::kVelocity) commands[joint].rate_radps = target.value;
      } else if (joint < count + 2 && target.mode == JointMode::kPosition) {
        commands[joint - count].steer_rad = target.value;
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    physics->SetWheel(agent.body, i, commands[i].rate_radps, commands[i].steer_rad);
  }
}

}  // namespace latticeworld
