#include "latticeworld/simulation/agents/ways/steering.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/minds/surroundings.h"

namespace latticeworld {
double DistanceBetween(WorldPoint a, WorldPoint b) {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

double HeadingTo(WorldPoint from, WorldPoint to) {
  return std::atan2(to.y_m - from.y_m, to.x_m - from.x_m);
}

WorldPoint Ahead(WorldPoint from, double heading_rad, double distance_m) {
  return {from.x_m + distance_m * std::cos(heading_rad),
          from.y_m + distance_m * std::sin(heading_rad)};
}

double WrapAngle(double angle_rad) { return std::remainder(angle_rad, 2.0 * M_PI); }

double HighestAhead(const Surroundings& world, WorldPoint from, double heading_rad, double reach_m,
                    double radius_m) {
  constexpr double kStride_m = 4.0;
  double highest_m = -1e9;
  for (double s = 0.0; s <= reach_m; s += kStride_m) {
    const WorldPoint place = Ahead(from, heading_rad, s);
    highest_m = std::max(highest_m, world.SurfaceHeightAt(place));
    world.scene->index.ForEachNear(place, radius_m + 0.5 * kStride_m, [&](std::uint32_t index) {
      if (!world.changes->empty() && !world.changes->Stands(index)) return;
      const Asset& asset = world.scene->assets[index];
      highest_m = std::max(highest_m, static_cast<double>(asset.z_m) + asset.height_m);
    });
  }
  return highest_m;
}

VelocityCommand Follow(const Steering& steering, const Agent& agent) {
  constexpr double kTurnGain_hz = 3.0;
  constexpr double kClimbGain_hz = 1.0;
  constexpr double kHoldGain_hz = 0.8;
  const Species& species = *agent.species;
  VelocityCommand command;
  if (steering.base_z_m.has_value()) {
    command.linear_mps.z() =
        std::clamp(kClimbGain_hz * (*steering.base_z_m - agent.motion.position_m.z()),
                   -0.5 * species.top_speed_mps, 0.5 * species.top_speed_mps);
  }
  if (steering.hold.has_value()) {
    Eigen::Vector3d off_m(steering.hold->x_m, steering.hold->y_m, 0.0);
    off_m.head<2>() -= agent.motion.position_m.head<2>();
    const Eigen::Vector3d wanted =
        agent.motion.orientation.conjugate() * Eigen::Vector3d(kHoldGain_hz * off_m);
    const double share = std::min(1.0, species.cruise_mps / std::max(1e-9, wanted.norm()));
    command.linear_mps.head<2>() = share * wanted.head<2>();
  }
  if (steering.speed_mps == 0.0) return command;
  const double error_rad = WrapAngle(steering.heading_rad - agent.motion.yaw_rad());
  double turn_rate_radps = species.turn_rate_radps;
  // What keeps to a place only turns there.
  if (steering.hold.has_value()) {
    command.yaw_rate_radps =
        std::clamp(kTurnGain_hz * error_rad, -turn_rate_radps, turn_rate_radps);
    return command;
  }
  // Slower while it turns. Wings cannot stop for a turn, they fly a wider one; steered wheels turn
  // only where they roll.
  double slowest = species.plan == BodyPlan::kFlyer ? 0.5 : 0.0;
  if (TurningRadius(species) > 0.0) slowest = steering.speed_mps < 0.0 ? 1.0 : 0.4;
  command.linear_mps.x() = steering.speed_mps * std::max(slowest, std::cos(error_rad));
  if (TurningRadius(species) > 0.0)
    turn_rate_radps =
        std::min(turn_rate_radps, std::abs(command.linear_mps.x()) / TurningRadius(species));
  command.yaw_rate_radps = std::clamp(kTurnGain_hz * error_rad, -turn_rate_radps, turn_rate_radps);
  return command;
}

double TurningRadius(const Species& species) {
  if (!species.vehicle.has_value() || species.vehicle->drive != DriveKind::kAckermann) return 0.0;
  return species.vehicle->wheelbase_m / std::tan(std::max(0.05, species.vehicle->max_steering_rad));
}

}  // namespace latticeworld
