#include "latticeworld/simulation/agents/steering.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/species.h"
#include "latticeworld/simulation/agents/surroundings.h"

namespace latticeworld {
namespace {

constexpr double kClearance_m = 0.25;  // kept from solid things beside the body's own radius
constexpr double kEdge_m = 0.3;        // kept from the edge of the world
constexpr double kArrived_m = 0.3;

}  // namespace

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

bool CanStand(const Surroundings& world, const Agent& agent, WorldPoint place) {
  const double half_m = world.scene.geometry().half_size_m() - agent.radius_m - kEdge_m;
  if (std::abs(place.x_m) > half_m || std::abs(place.y_m) > half_m) return false;
  const Species& species = SpeciesOf(agent.category);
  const Locomotion locomotion = LocomotionOf(agent.category);
  if (locomotion == Locomotion::kWings) return true;
  const double depth_m = world.WaterDepthAt(place);
  if (locomotion == Locomotion::kFins) return depth_m >= species.wade_depth_m;
  if (depth_m > species.wade_depth_m) return false;
  // No steeper than it can climb, nor than its feet hold on wet or snowy ground.
  const double friction = world.surfaces.Of(world.scene.terrain->SurfaceAt(place)).friction;
  const double max_slope_rad = std::min(species.max_slope_rad, std::atan(species.grip * friction));
  if (world.scene.terrain->ground.SlopeAt(place) > max_slope_rad) return false;
  bool clear = true;
  const double margin_m = agent.radius_m + kClearance_m;
  world.scene.index.ForEachNear(place, margin_m, [&](std::uint32_t index) {
    clear = clear && !SolidContains(world.scene.assets[index], place, margin_m);
  });
  return clear;
}

bool CanGo(const Surroundings& world, const Agent& agent, WorldPoint from, WorldPoint to) {
  // From where it should not be (pushed, or begun too close to something) any way out will do.
  if (!CanStand(world, agent, from)) return CanStand(world, agent, to);
  const double length_m = DistanceBetween(from, to);
  const double stride_m = LocomotionOf(agent.category) == Locomotion::kFins ? 2.0 : 0.5;
  const int strides = std::max(1, static_cast<int>(std::ceil(length_m / stride_m)));
  for (int i = 1; i <= strides; ++i) {
    const double share = static_cast<double>(i) / strides;
    const WorldPoint place{from.x_m + share * (to.x_m - from.x_m),
                           from.y_m + share * (to.y_m - from.y_m)};
    if (!CanStand(world, agent, place)) return false;
  }
  return true;
}

std::optional<double> ClearHeading(const Surroundings& world, Agent* agent, double wanted_rad,
                                   double look_m) {
  constexpr double kTurns_rad[] = {0.0, 0.4, 0.8, 1.2, 1.6, 2.1, 2.7};
  const WorldPoint here = agent->place();
  for (const double turn_rad : kTurns_rad) {
    for (const int side : {agent->mind.turn_side, -agent->mind.turn_side}) {
      const double heading_rad = WrapAngle(wanted_rad + side * turn_rad);
      if (!CanGo(world, *agent, here, Ahead(here, heading_rad, look_m))) continue;
      if (turn_rad > 0.0) agent->mind.turn_side = side;
      return heading_rad;
    }
  }
  return std::nullopt;
}

Steering SteerTo(const Surroundings& world, Agent* agent, WorldPoint place, double speed_mps) {
  Steering steering;
  const WorldPoint here = agent->place();
  const double distance_m = DistanceBetween(here, place);
  steering.heading_rad = agent->motion.yaw_rad();
  if (distance_m < kArrived_m) return steering;
  const double look_m = std::min(distance_m, std::max(2.0, 1.5 * speed_mps) + agent->radius_m);
  if (const auto heading = ClearHeading(world, agent, HeadingTo(here, place), look_m)) {
    steering.heading_rad = *heading;
    steering.speed_mps = speed_mps;
  }
  return steering;
}

double HighestAhead(const Surroundings& world, WorldPoint from, double heading_rad, double reach_m,
                    double radius_m) {
  constexpr double kStride_m = 4.0;
  double highest_m = -1e9;
  for (double s = 0.0; s <= reach_m; s += kStride_m) {
    const WorldPoint place = Ahead(from, heading_rad, s);
    highest_m = std::max(highest_m,
                         world.scene.terrain->ground.HeightAt(place) + world.WaterDepthAt(place));
    world.scene.index.ForEachNear(place, radius_m + 0.5 * kStride_m, [&](std::uint32_t index) {
      const Asset& asset = world.scene.assets[index];
      highest_m = std::max(highest_m, static_cast<double>(asset.z_m) + asset.height_m);
    });
  }
  return highest_m;
}

VelocityCommand Follow(const Steering& steering, const Agent& agent) {
  constexpr double kTurnGain_hz = 3.0;
  constexpr double kClimbGain_hz = 1.0;
  constexpr double kHoldGain_hz = 0.8;
  const Species& species = SpeciesOf(agent.category);
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
  if (steering.speed_mps <= 0.0) return command;
  const double error_rad = WrapAngle(steering.heading_rad - agent.motion.yaw_rad());
  command.yaw_rate_radps =
      std::clamp(kTurnGain_hz * error_rad, -species.turn_rate_radps, species.turn_rate_radps);
  // Slower while it turns; wings cannot stop for a turn, they fly a wider one.
  const double slowest = LocomotionOf(agent.category) == Locomotion::kWings ? 0.5 : 0.0;
  command.linear_mps.x() = steering.speed_mps * std::max(slowest, std::cos(error_rad));
  return command;
}

}  // namespace latticeworld
