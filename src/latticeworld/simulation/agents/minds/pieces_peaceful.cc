#include "latticeworld/simulation/agents/minds/pieces_peaceful.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/minds/herd.h"
#include "latticeworld/simulation/agents/ways/places.h"
#include "latticeworld/simulation/agents/ways/steering.h"

namespace latticeworld {
namespace {

bool IsGrass(const Surroundings& world, WorldPoint place) {
  return world.scene->geometry().Contains(place) &&
         world.scene->terrain->SurfaceAt(place) == SurfaceClass::kGrass;
}

bool GrassAllTheWay(const Surroundings& world, WorldPoint from, WorldPoint to) {
  if (!IsGrass(world, from)) return IsGrass(world, to);  // astray: back to any grass
  constexpr double kStride_m = 1.0;
  return HoldsAlong(from, to, kStride_m, [&](WorldPoint place) { return IsGrass(world, place); });
}

bool Pauses(const Agent& agent, const Surroundings& world) {
  return world.episode_step < agent.mind.pause_until;
}

// Stands while it pauses, and pauses once it has come to its goal; nullopt: it goes on.
std::optional<Steering> PauseBetween(Agent* agent, const Surroundings& world, double low_s,
                                     double high_s) {
  if (Pauses(*agent, world)) return StandHere(*agent);
  if (!agent->mind.goal.has_value() || !GoalDone(*agent, world)) return std::nullopt;
  PauseFor(agent, world, low_s, high_s);
  return StandHere(*agent);
}

}  // namespace

std::optional<Steering> Idle(Agent* agent, Surroundings* world) {
  constexpr double kAstray_m = 3.0, kHome_m = 1.0;
  TakeUp(agent, Behaviour::kIdle);
  Mind& mind = agent->mind;
  const double away_m = DistanceBetween(agent->place(), mind.home);
  if (away_m > kAstray_m) mind.goal = mind.home;
  if (away_m < kHome_m) mind.goal.reset();
  if (!mind.goal.has_value()) {
    Steering steering = StandHere(*agent);
    KeepToHome(*agent, &steering);
    return steering;
  }
  return GoTo(agent, world, *mind.goal, agent->species->cruise_mps);
}

std::optional<Steering> Wander(Agent* agent, Surroundings* world) {
  constexpr double kNear_m = 5.0, kFar_m = 25.0;
  TakeUp(agent, Behaviour::kWander);
  Mind& mind = agent->mind;
  if (const auto pause = PauseBetween(agent, *world, 1.0, 4.0)) return pause;
  const double speed_mps = agent->species->cruise_mps;
  if (!mind.goal.has_value()) {
    const WorldPoint here = agent->place();
    const auto place = DrawPlace(agent, *world, here, here, kNear_m, kFar_m);
    if (!place.has_value()) {
      PauseFor(agent, *world, 1.0, 2.0);
      return StandHere(*agent);
    }
    SetGoal(agent, *world, *place, speed_mps);
  }
  return GoTo(agent, world, *mind.goal, speed_mps);
}

std::optional<Steering> Patrol(Agent* agent, Surroundings* world) {
  constexpr std::size_t kPlaces = 5;
  constexpr double kNear_m = 6.0, kFar_m = 30.0;
  TakeUp(agent, Behaviour::kPatrol);
  Mind& mind = agent->mind;
  if (Pauses(*agent, *world)) return StandHere(*agent);
  const double speed_mps = agent->species->cruise_mps;
  if (mind.goal.has_value() && GoalDone(*agent, *world)) {
    ++mind.next_place;
    mind.goal.reset();
  }
  if (!mind.goal.has_value()) {
    // The route grows by a place whenever it is walked to its end, so that planning it is spread
    // over time.
    if (mind.next_place >= mind.route.size() && mind.route.size() < kPlaces) {
      const auto place = DrawPlace(agent, *world, mind.home, agent->place(), kNear_m, kFar_m);
      if (place.has_value()) mind.route.push_back(*place);
    }
    if (mind.route.empty()) {
      PauseFor(agent, *world, 2.0, 5.0);
      return StandHere(*agent);
    }
    mind.next_place %= mind.route.size();
    SetGoal(agent, *world, mind.route[mind.next_place], speed_mps);
  }
  return GoTo(agent, world, *mind.goal, speed_mps);
}

std::optional<Steering> Graze(Agent* agent, Surroundings* world) {
  constexpr double kNear_m = 1.5, kFar_m = 6.0;
  constexpr double kDrawn_m = 5.0;  // how far the herd draws the next patch
  if (KeepsAfloat(agent->species->plan)) return std::nullopt;
  TakeUp(agent, Behaviour::kGraze);
  Mind& mind = agent->mind;
  if (const auto pause = PauseBetween(agent, *world, 2.0, 8.0)) return pause;
  const double speed_mps = agent->species->cruise_mps;
  const WorldPoint here = agent->place();
  if (!mind.goal.has_value()) {
    // The more the herd draws it, the more the next patch lies that way.
    const Eigen::Vector2d drawn = Flocking(*agent, *world);
    const WorldPoint center{here.x_m + kDrawn_m * drawn.x(), here.y_m + kDrawn_m * drawn.y()};
    const double far_m = kFar_m - (kFar_m - kNear_m) * 0.8 * std::min(1.0, drawn.norm());
    const auto patch = DrawPlace(agent, *world, center, here, kNear_m, far_m);
    if (!patch.has_value() || !GrassAllTheWay(*world, here, *patch)) {
      mind.pause_until = world->In(0.5);
      return StandHere(*agent);
    }
    SetGoal(agent, *world, *patch, speed_mps);
  }
  const Steering steering = GoTo(agent, world, *mind.goal, speed_mps);
  // Around an obstacle the way may lead off the grass: better to look for another patch.
  if (IsGrass(*world, here) && !IsGrass(*world, Ahead(here, steering.heading_rad, 1.0))) {
    PauseFor(agent, *world, 0.5, 2.0);
    return StandHere(*agent);
  }
  return steering;
}

std::optional<Steering> Swim(Agent* agent, Surroundings* world) {
  if (agent->species->plan != BodyPlan::kSwimmer) return std::nullopt;
  TakeUp(agent, Behaviour::kSwim);
  Mind& mind = agent->mind;
  const Species& species = *agent->species;
  const WorldPoint here = agent->place();
  if (mind.goal.has_value() && GoalDone(*agent, *world)) mind.goal.reset();
  if (!mind.goal.has_value()) {
    const auto place = DrawPlace(agent, *world, here, here, 10.0, 60.0);
    if (place.has_value()) SetGoal(agent, *world, *place, species.cruise_mps);
  }
  Steering steering = mind.goal.has_value() ? GoTo(agent, world, *mind.goal, species.cruise_mps)
                                            : StandHere(*agent);
  steering.base_z_m = HeightOnTheWay(*agent, *world, steering.heading_rad, steering.speed_mps);
  return steering;
}

std::optional<Steering> Soar(Agent* agent, Surroundings* world) {
  constexpr double kWidest_m = 25.0, kNarrowest_m = 8.0;  // circle; small worlds have small ones
  constexpr double kEdge_m = 5.0;
  constexpr double kLead_rad = 0.5;
  if (agent->species->plan != BodyPlan::kFlyer) return std::nullopt;
  TakeUp(agent, Behaviour::kSoar);
  const WorldPoint here = agent->place();
  const double size_m = world->scene->geometry().half_size_m();
  const double circle_m = std::clamp(size_m - 2.0 * kEdge_m, kNarrowest_m, kWidest_m);
  const double half_m = std::max(0.0, size_m - circle_m - kEdge_m);
  const WorldPoint center{std::clamp(agent->mind.home.x_m, -half_m, half_m),
                          std::clamp(agent->mind.home.y_m, -half_m, half_m)};
  const double bearing_rad = HeadingTo(center, here);
  const WorldPoint carrot =
      Ahead(center, bearing_rad + agent->mind.turn_side * kLead_rad, circle_m);
  Steering steering;
  steering.heading_rad = HeadingTo(here, carrot);
  steering.speed_mps = agent->species->cruise_mps;
  steering.base_z_m = HeightOnTheWay(*agent, *world, steering.heading_rad, steering.speed_mps);
  return steering;
}

}  // namespace latticeworld
