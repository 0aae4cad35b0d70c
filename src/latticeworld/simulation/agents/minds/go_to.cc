#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/minds/look_around.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"
#include "latticeworld/simulation/agents/ways/avoidance.h"
#include "latticeworld/simulation/agents/ways/path_following.h"
#include "latticeworld/simulation/agents/ways/steering.h"

namespace latticeworld {
namespace {

constexpr double kArrived_m = 0.3;
// Everybody passes on the right, so that two who meet head on do not wait for each other.
constexpr double kKeepRight_rad = 0.08;
constexpr double kSidestep_rad = 1.2;  // from the way, when stuck

// Returns the velocity that is as fast and as near to the wanted heading as others let it, map
// frame.
Eigen::Vector2d AroundOthers(const Agent& agent, const Surroundings& world, double heading_rad,
                             double speed_mps) {
  const std::vector<AvoidedBody> bodies = BodiesToAvoid(agent, world);
  if (bodies.empty())
    return speed_mps * Eigen::Vector2d(std::cos(heading_rad), std::sin(heading_rad));
  AvoidanceOptions options;
  options.top_speed_mps = speed_mps;
  const double right_rad = heading_rad - kKeepRight_rad;
  const Eigen::Vector2d preferred_mps =
      speed_mps * Eigen::Vector2d(std::cos(right_rad), std::sin(right_rad));
  return AvoidingVelocity(agent.motion.linear_velocity_mps.head<2>(), preferred_mps, bodies,
                          options);
}

// Steered wheels: forward in an arc where that leads there, else back first, turning to it. Where
// there is room for neither, back and forth over what room there is, turning each time.
void SteerWheels(const Agent& agent, const LookAround& look, WorldPoint corner,
                 Steering* steering) {
  constexpr double kBent_rad = 0.3;  // from here on the arc is not the straight way that was seen
  constexpr double kShares[] = {0.5, 0.25, 0.12};  // of the usual room
  constexpr double kCrawl_s = 1.0;                 // over the room that there is
  const double yaw_rad = agent.motion.yaw_rad();
  const double error_rad = WrapAngle(steering->heading_rad - yaw_rad);
  if (std::abs(error_rad) < kBent_rad) return;
  const double radius_m = TurningRadius(*agent.species);
  const double ahead_m = 1.0 + agent.species->radius_m;
  const double side = error_rad > 0.0 ? 1.0 : -1.0;
  const WorldPoint pivot = Ahead(agent.place(), yaw_rad + side * M_PI / 2, radius_m);
  // Once it backs up it does so for a while, not back and forth on the circle's rim.
  const bool backs_up = agent.mind.steering.speed_mps < 0.0;
  const double rim_m = (backs_up ? 1.2 : 1.0) * radius_m;
  const bool inside = DistanceBetween(pivot, corner) < rim_m;
  const bool forward = look.CanGo(yaw_rad, ahead_m);
  if (forward && !inside) return;
  if (look.CanGo(yaw_rad + M_PI, ahead_m)) {
    steering->speed_mps = -0.5 * steering->speed_mps;
    return;
  }
  if (forward) return;
  for (const double share : kShares) {
    const double room_m = share * ahead_m;
    const bool can_go[] = {look.CanGo(yaw_rad, room_m), look.CanGo(yaw_rad + M_PI, room_m)};
    if (!can_go[0] && !can_go[1]) continue;
    const bool back = can_go[backs_up ? 1 : 0] ? backs_up : !backs_up;
    steering->speed_mps = (back ? -1.0 : 1.0) * std::min(steering->speed_mps, room_m / kCrawl_s);
    return;
  }
  steering->speed_mps = 0.0;
}

}  // namespace

std::optional<double> HeightOnTheWay(const Agent& agent, const Surroundings& world,
                                     double heading_rad, double speed_mps) {
  const Species& species = *agent.species;
  const WorldPoint here = agent.place();
  if (species.plan == BodyPlan::kFlyer) {
    const double reach_m = 2.0 * speed_mps + 4.0;
    return species.altitude_m + HighestAhead(world, here, heading_rad, reach_m, species.radius_m);
  }
  if (species.plan == BodyPlan::kSwimmer) {
    // Halfway between bed and surface, with its back covered.
    constexpr double kAboveBed_m = 0.2;
    const double depth_m = world.WaterDepthAt(here);
    return world.scene->terrain->ground.HeightAt(here) +
           std::max(kAboveBed_m, 0.5 * (depth_m - species.height_m));
  }
  return std::nullopt;
}

Steering GoTo(Agent* agent, Surroundings* world, WorldPoint place, double speed_mps) {
  const Species& species = *agent->species;
  const bool flies = species.plan == BodyPlan::kFlyer;
  const WorldPoint here = agent->place();
  Steering steering;
  steering.heading_rad = agent->motion.yaw_rad();
  const double distance_m = DistanceBetween(here, place);
  if (distance_m < kArrived_m || speed_mps <= 0.0) {
    steering.base_z_m = HeightOnTheWay(*agent, *world, steering.heading_rad, 0.0);
    if (steering.base_z_m.has_value()) steering.hold = speed_mps > 0.0 ? place : here;
    return steering;
  }

  const WorldPoint corner = flies ? place : NextCorner(agent, world, place).value_or(place);
  double wanted_rad = HeadingTo(here, corner);
  const bool turns_on_the_spot = TurningRadius(species) == 0.0;
  if (!flies && turns_on_the_spot && world->episode_step < agent->mind.path.sidestep_until)
    wanted_rad += agent->mind.turn_side * kSidestep_rad;
  const Eigen::Vector2d velocity_mps = AroundOthers(*agent, *world, wanted_rad, speed_mps);
  const double free_mps = velocity_mps.norm();
  constexpr double kTooSlow_mps = 0.05;  // others leave it no room: it waits
  if (free_mps > kTooSlow_mps) {
    const double reach_m = std::max(1.5, 1.2 * speed_mps) + species.radius_m;
    const LookAround look(*world, *agent, std::max(reach_m, 1.0 + species.radius_m));
    const double free_rad = std::atan2(velocity_mps.y(), velocity_mps.x());
    const double look_m = std::min(reach_m, std::max(kArrived_m, DistanceBetween(here, corner)));
    if (const auto heading = look.ClearHeading(free_rad, look_m, &agent->mind.turn_side)) {
      steering.heading_rad = *heading;
      steering.speed_mps = std::min(speed_mps, free_mps);
      if (!turns_on_the_spot) SteerWheels(*agent, look, corner, &steering);
    }
  }
  steering.base_z_m = HeightOnTheWay(*agent, *world, steering.heading_rad, speed_mps);
  if (steering.speed_mps == 0.0 && steering.base_z_m.has_value()) steering.hold = here;
  return steering;
}

}  // namespace latticeworld
