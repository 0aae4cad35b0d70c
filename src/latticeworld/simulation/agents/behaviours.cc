#include "latticeworld/simulation/agents/behaviours.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/species.h"
#include "latticeworld/simulation/agents/steering.h"

namespace latticeworld {
namespace {

constexpr double kArrived_m = 1.0;
constexpr int kTries = 24;  // draws of a place before the agent waits for its next thought

bool Passable(const Surroundings& world, WorldPoint place) {
  return world.traversability[world.scene.geometry().CellAt(place)] > 0.0f;
}

WorldPoint DrawAround(WorldPoint center, double near_m, double far_m, RandomStream* random) {
  const double heading_rad = random->Uniform(-M_PI, M_PI);
  return Ahead(center, heading_rad, random->Uniform(near_m, far_m));
}

// Another draw's chance of a place that the agent can go to in a straight line.
std::optional<WorldPoint> DrawReachable(Agent* agent, const Surroundings& world, WorldPoint center,
                                        WorldPoint from, double near_m, double far_m) {
  const bool on_foot = LocomotionOf(agent->category) == Locomotion::kWheels ||
                       LocomotionOf(agent->category) == Locomotion::kLegs;
  for (int i = 0; i < kTries; ++i) {
    const WorldPoint place = DrawAround(center, near_m, far_m, &agent->mind.random);
    if (!world.scene.geometry().Contains(place)) continue;
    if (on_foot && !Passable(world, place)) continue;
    if (CanGo(world, *agent, from, place)) return place;
  }
  return std::nullopt;
}

void PlanRoute(Agent* agent, const Surroundings& world) {
  constexpr int kPlaces = 5;
  constexpr double kNear_m = 6.0, kFar_m = 30.0;
  WorldPoint from = agent->place();
  for (int i = 0; i < kPlaces; ++i) {
    const auto place = DrawReachable(agent, world, agent->mind.home, from, kNear_m, kFar_m);
    if (!place.has_value()) continue;
    agent->mind.route.push_back(*place);
    from = *place;
  }
}

bool IsGrass(const Surroundings& world, WorldPoint place) {
  return world.scene.terrain->SurfaceAt(place) == SurfaceClass::kGrass;
}

bool GrassAllTheWay(const Surroundings& world, WorldPoint from, WorldPoint to) {
  if (!IsGrass(world, from)) return IsGrass(world, to);  // astray: back to any grass
  const int strides = std::max(1, static_cast<int>(std::ceil(DistanceBetween(from, to))));
  for (int i = 1; i <= strides; ++i) {
    const double share = static_cast<double>(i) / strides;
    if (!IsGrass(world, {from.x_m + share * (to.x_m - from.x_m),
                         from.y_m + share * (to.y_m - from.y_m)})) {
      return false;
    }
  }
  return true;
}

// The middle of its own kind within sight of each other; its own place when it is alone.
WorldPoint HerdCenter(const Agent& agent, const Surroundings& world) {
  constexpr double kHerd_m = 40.0;
  WorldPoint sum{0.0, 0.0};
  int count = 0;
  for (const auto& [id, other] : world.agents) {
    if (other.category != agent.category || !other.alive()) continue;
    const WorldPoint place = other.place();
    if (DistanceBetween(place, agent.place()) > kHerd_m) continue;
    sum.x_m += place.x_m;
    sum.y_m += place.y_m;
    ++count;
  }
  if (count == 0) return agent.place();
  return {sum.x_m / count, sum.y_m / count};
}

void PauseFor(Agent* agent, const Surroundings& world, double low_s, double high_s) {
  agent->mind.goal.reset();
  agent->mind.pause_until = world.In(agent->mind.random.Uniform(low_s, high_s));
}

// Goes to the mind's goal; true once there or past the time for it.
bool GoalDone(const Agent& agent, const Surroundings& world) {
  return DistanceBetween(agent.place(), *agent.mind.goal) < kArrived_m + 0.5 * agent.radius_m ||
         world.episode_step >= agent.mind.goal_until;
}

void SetGoal(Agent* agent, const Surroundings& world, WorldPoint goal, double speed_mps) {
  agent->mind.goal = goal;
  const double straight_s = DistanceBetween(agent->place(), goal) / speed_mps;
  agent->mind.goal_until = world.In(5.0 + 3.0 * straight_s);
}

}  // namespace

Steering Rest(const Agent& agent) {
  Steering steering;
  steering.heading_rad = agent.motion.yaw_rad();
  const Locomotion locomotion = LocomotionOf(agent.category);
  if (locomotion == Locomotion::kWings || locomotion == Locomotion::kFins) {
    steering.base_z_m = agent.mind.home_z_m;
    steering.hold = agent.mind.home;
  }
  return steering;
}

Steering Travel(Agent* agent, Surroundings* world, WorldPoint place, double speed_mps) {
  Steering steering = SteerTo(*world, agent, place, speed_mps);
  if (LocomotionOf(agent->category) == Locomotion::kWings) {
    const double reach_m = 2.0 * speed_mps + 4.0;
    steering.base_z_m =
        SpeciesOf(agent->category).altitude_m +
        HighestAhead(*world, agent->place(), steering.heading_rad, reach_m, agent->radius_m);
  }
  return steering;
}

Steering Patrol(Agent* agent, Surroundings* world) {
  Mind& mind = agent->mind;
  if (world->episode_step < mind.pause_until) return Rest(*agent);
  if (mind.route.empty()) PlanRoute(agent, *world);
  if (mind.route.empty()) {
    PauseFor(agent, *world, 2.0, 5.0);
    return Rest(*agent);
  }
  const double speed_mps = SpeciesOf(agent->category).cruise_mps;
  if (mind.goal.has_value() && GoalDone(*agent, *world)) {
    mind.next_place = (mind.next_place + 1) % mind.route.size();
    mind.goal.reset();
  }
  if (!mind.goal.has_value()) SetGoal(agent, *world, mind.route[mind.next_place], speed_mps);
  return Travel(agent, world, *mind.goal, speed_mps);
}

Steering Graze(Agent* agent, Surroundings* world) {
  constexpr double kHerdRadius_m = 12.0;
  Mind& mind = agent->mind;
  if (world->episode_step < mind.pause_until) return Rest(*agent);
  if (mind.goal.has_value() && GoalDone(*agent, *world)) {
    PauseFor(agent, *world, 2.0, 8.0);
    return Rest(*agent);
  }
  const double speed_mps = SpeciesOf(agent->category).cruise_mps;
  const WorldPoint here = agent->place();
  if (!mind.goal.has_value()) {
    // Next patch near here; far from the herd, towards it.
    const WorldPoint herd = HerdCenter(*agent, *world);
    const bool astray = DistanceBetween(here, herd) > kHerdRadius_m;
    const WorldPoint center = astray ? Ahead(here, HeadingTo(here, herd), 5.0) : here;
    const auto patch = DrawReachable(agent, *world, center, here, 1.5, 6.0);
    if (!patch.has_value() || !GrassAllTheWay(*world, here, *patch)) {
      mind.pause_until = world->In(0.5);
      return Rest(*agent);
    }
    SetGoal(agent, *world, *patch, speed_mps);
  }
  const Steering steering = SteerTo(*world, agent, *mind.goal, speed_mps);
  // Around an obstacle the way may lead off the grass: better to look for another patch.
  if (IsGrass(*world, here) && !IsGrass(*world, Ahead(here, steering.heading_rad, 1.0))) {
    PauseFor(agent, *world, 0.5, 2.0);
    return Rest(*agent);
  }
  return steering;
}

Steering Swim(Agent* agent, Surroundings* world) {
  Mind& mind = agent->mind;
  const Species& species = SpeciesOf(agent->category);
  const WorldPoint here = agent->place();
  if (mind.goal.has_value() && GoalDone(*agent, *world)) mind.goal.reset();
  if (!mind.goal.has_value()) {
    const auto place = DrawReachable(agent, *world, here, here, 10.0, 60.0);
    if (place.has_value()) SetGoal(agent, *world, *place, species.cruise_mps);
  }
  Steering steering =
      mind.goal.has_value() ? SteerTo(*world, agent, *mind.goal, species.cruise_mps) : Rest(*agent);
  // Halfway between bed and surface, with its back covered.
  const double bed_m = world->scene.terrain->ground.HeightAt(here);
  const double depth_m = world->WaterDepthAt(here);
  steering.base_z_m = bed_m + std::max(0.2, 0.5 * (depth_m - species.height_m));
  return steering;
}

Steering Soar(Agent* agent, Surroundings* world) {
  constexpr double kCircle_m = 25.0;
  constexpr double kLead_rad = 0.5;
  const WorldPoint here = agent->place();
  const double half_m = world->scene.geometry().half_size_m() - kCircle_m - 5.0;
  const WorldPoint center{std::clamp(agent->mind.home.x_m, -half_m, half_m),
                          std::clamp(agent->mind.home.y_m, -half_m, half_m)};
  const double bearing_rad = HeadingTo(center, here);
  const WorldPoint carrot =
      Ahead(center, bearing_rad + agent->mind.turn_side * kLead_rad, kCircle_m);
  Steering steering;
  steering.heading_rad = HeadingTo(here, carrot);
  steering.speed_mps = SpeciesOf(agent->category).cruise_mps;
  const double reach_m = 2.0 * steering.speed_mps + 4.0;
  steering.base_z_m = SpeciesOf(agent->category).altitude_m +
                      HighestAhead(*world, here, steering.heading_rad, reach_m, agent->radius_m);
  return steering;
}

}  // namespace latticeworld
