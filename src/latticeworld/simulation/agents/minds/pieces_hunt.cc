#include "latticeworld/simulation/agents/minds/pieces_hunt.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/simulation/agents/minds/fights.h"
#include "latticeworld/simulation/agents/minds/perception.h"
#include "latticeworld/simulation/agents/minds/targets.h"
#include "latticeworld/simulation/agents/ways/places.h"
#include "latticeworld/simulation/agents/ways/steering.h"

namespace latticeworld {
namespace {

constexpr double kGiveUp = 1.5;     // times the distance at which a target is taken
constexpr double kUnseen_s = 3.0;   // runs on after a target that it does not see for so long
constexpr double kUpon_m = 8.0;     // who comes nearer than this may mean to strike
constexpr double kGuarded = 0.6;    // times the pursuit distance: radius of what is guarded
constexpr double kWatched_m = 1.0;  // one that cannot strike keeps so near to its target

const Sighting* TargetOf(const Agent& agent) {
  return agent.mind.target == 0 ? nullptr : MemoryOf(agent, agent.mind.target);
}

// Returns where the target of a chase was last seen; nullptr: it has been out of sight for long.
const Sighting* ChasedTarget(const Agent& agent, const Surroundings& world) {
  const Sighting* target = TargetOf(agent);
  return target != nullptr && AgeOf(*target, world) <= kUnseen_s ? target : nullptr;
}

Steering RunTo(Agent* agent, Surroundings* world, const Sighting& target, WorldPoint place) {
  const Agent& other = world->agents->at(target.who);
  if (target.seen_now && !CanStrike(*agent) && GapBetween(*agent, other) < kWatched_m) {
    return FaceTo(*agent, PlaceOf(target));
  }
  Steering steering = GoTo(agent, world, place, agent->species->top_speed_mps);
  // Flyers that strike come down on their target.
  constexpr double kDive_m = 25.0;
  if (agent->species->plan == BodyPlan::kFlyer && CanStrike(*agent) &&
      DistanceBetween(agent->place(), place) < kDive_m) {
    steering.base_z_m = target.position_m.z() + 0.5 * other.species->height_m;
  }
  return steering;
}

// Returns when a runner at that speed can be where the other is then, who keeps its velocity [s]:
// the smaller positive root of |offset + velocity t| = speed t, at most longest_s.
double TimeToMeet(const Eigen::Vector2d& offset_m, const Eigen::Vector2d& velocity_mps,
                  double speed_mps, double longest_s) {
  const double a = velocity_mps.squaredNorm() - speed_mps * speed_mps;
  const double b = offset_m.dot(velocity_mps);
  const double c = offset_m.squaredNorm();
  if (std::abs(a) < 1e-9) return b < 0.0 ? std::min(longest_s, -0.5 * c / b) : longest_s;
  const double under_root = b * b - a * c;
  if (under_root < 0.0) return longest_s;
  const double root = std::sqrt(under_root);
  double best_s = longest_s;
  for (const double t : {(-b - root) / a, (-b + root) / a}) {
    if (t > 0.0) best_s = std::min(best_s, t);
  }
  return best_s;
}

void ForgetTarget(Mind* mind) {
  const auto is_target = [&](const Sighting& sighting) { return sighting.who == mind->target; };
  mind->memory.erase(std::remove_if(mind->memory.begin(), mind->memory.end(), is_target),
                     mind->memory.end());
  mind->target = 0;
}

// Goes from place to place around a middle, to the middle first.
Steering SearchAround(Agent* agent, Surroundings* world, WorldPoint middle) {
  constexpr double kNear_m = 3.0, kFar_m = 9.0;
  Mind& mind = agent->mind;
  const double speed_mps = 0.5 * (agent->species->cruise_mps + agent->species->top_speed_mps);
  if (!mind.goal.has_value()) {
    SetGoal(agent, *world, middle, speed_mps);
  } else if (GoalDone(*agent, *world)) {
    const auto place = DrawPlace(agent, *world, middle, agent->place(), kNear_m, kFar_m);
    if (!place.has_value()) return StandHere(*agent);
    SetGoal(agent, *world, *place, speed_mps);
  }
  return GoTo(agent, world, *mind.goal, speed_mps);
}

}  // namespace

Piece WithTarget(std::string name, Chooser choose, Piece piece) {
  const auto has_target = [choose](Agent* agent, Surroundings* world) {
    const AgentId before = agent->mind.target;
    choose(agent, world);
    const AgentId target = agent->mind.target;
    if (target == before) return target != 0;
    agent->mind.closes_at = 0;
    if (target == 0) return false;
    world->Tell(EventKind::kPursued, *agent, world->agents->at(target).name);
    return true;
  };
  return Gated(std::move(name), has_target, std::move(piece));
}

void ChoosePrey(Agent* agent, Surroundings* world) {
  KeepOrTakeTarget(agent, *world, world->pursuit_distance_m, kGiveUp * world->pursuit_distance_m);
}

void ChooseAssailant(Agent* agent, Surroundings* world) {
  KeepOrTakeTarget(agent, *world, kUpon_m, kGiveUp * kUpon_m);
  const Sighting* target = TargetOf(*agent);
  if (target != nullptr && AgeOf(*target, *world) > kUnseen_s) agent->mind.target = 0;
}

void ChooseIntruder(Agent* agent, Surroundings* world) {
  Mind& mind = agent->mind;
  const double guarded_m = kGuarded * world->pursuit_distance_m;
  KeepOrTakeTarget(agent, *world, world->pursuit_distance_m, 2.0 * guarded_m);
  const Sighting* target = TargetOf(*agent);
  if (target == nullptr) return;
  const bool near_home = DistanceBetween(PlaceOf(*target), mind.home) <= guarded_m;
  const bool far_out = DistanceBetween(agent->place(), mind.home) > kGiveUp * guarded_m;
  const bool strikes = target == Striker(*agent, *world);
  if ((!near_home && !strikes) || far_out || AgeOf(*target, *world) > kUnseen_s) mind.target = 0;
}

std::optional<Steering> Attack(Agent* agent, Surroundings* world) {
  constexpr double kFelt_s = 0.5;
  const Sighting* target = TargetOf(*agent);
  if (target == nullptr || !CanStrike(*agent) || AgeOf(*target, *world) > kFelt_s) {
    return std::nullopt;
  }
  const Agent& other = world->agents->at(target->who);
  if (GapBetween(*agent, other) > agent->species->attack_reach_m) return std::nullopt;
  TakeUp(agent, Behaviour::kAttack);
  Steering steering = FaceTo(*agent, PlaceOf(*target));
  // Steered wheels turn only where they roll: it backs up to face its target.
  if (TurningRadius(*agent->species) > 0.0 && !Faces(*agent, PlaceOf(*target))) {
    steering.speed_mps = -agent->species->cruise_mps;
  }
  steering.strike = target->who;
  return steering;
}

std::optional<Steering> Pursue(Agent* agent, Surroundings* world) {
  const Sighting* target = ChasedTarget(*agent, *world);
  if (target == nullptr) return std::nullopt;
  TakeUp(agent, Behaviour::kPursue);
  return RunTo(agent, world, *target, PlaceOf(*target));
}

std::optional<Steering> Intercept(Agent* agent, Surroundings* world) {
  constexpr double kLongest_s = 6.0;
  const Sighting* target = ChasedTarget(*agent, *world);
  if (target == nullptr) return std::nullopt;
  TakeUp(agent, Behaviour::kPursue);
  const Eigen::Vector2d velocity_mps = target->velocity_mps.head<2>();
  const Eigen::Vector2d offset_m = (target->position_m - agent->motion.position_m).head<2>() +
                                   AgeOf(*target, *world) * velocity_mps;
  const double lead_s =
      TimeToMeet(offset_m, velocity_mps, agent->species->top_speed_mps, kLongest_s);
  const Eigen::Vector2d there =
      agent->motion.position_m.head<2>() + offset_m + lead_s * velocity_mps;
  const WorldPoint place{there.x(), there.y()};
  const bool sensible = world->scene->geometry().Contains(place) && CanStand(*world, *agent, place);
  return RunTo(agent, world, *target, sensible ? place : PlaceOf(*target));
}

std::optional<Steering> Search(Agent* agent, Surroundings* world) {
  constexpr double kSearch_s = 12.0;
  constexpr double kLead_s = 1.5;  // it went on for so long as it was seen to go
  Mind& mind = agent->mind;
  const Sighting* target = TargetOf(*agent);
  if (target == nullptr) return std::nullopt;
  if (agent->behaviour != Behaviour::kSearch) mind.searched_until = world->In(kSearch_s);
  if (world->episode_step >= mind.searched_until) {
    ForgetTarget(&mind);
    return std::nullopt;
  }
  TakeUp(agent, Behaviour::kSearch);
  const Eigen::Vector3d lead_m = kLead_s * target->velocity_mps;
  const WorldPoint seen = PlaceOf(*target);
  const WorldPoint led{seen.x_m + lead_m.x(), seen.y_m + lead_m.y()};
  return SearchAround(agent, world, CanStand(*world, *agent, led) ? led : seen);
}

std::optional<Steering> LookIntoNoise(Agent* agent, Surroundings* world) {
  constexpr double kFresh_s = 5.0;
  const Sighting* noise = NearestEnemy(*agent, *world, world->pursuit_distance_m, kFresh_s);
  if (noise == nullptr || !noise->only_heard) return std::nullopt;
  TakeUp(agent, Behaviour::kSearch);
  agent->mind.goal.reset();  // follows the noise
  return GoTo(agent, world, PlaceOf(*noise), agent->species->cruise_mps);
}

std::optional<Steering> Guard(Agent* agent, Surroundings* world) {
  constexpr double kPost_m = 1.5, kLook_m = 5.0;
  TakeUp(agent, Behaviour::kGuard);
  Mind& mind = agent->mind;
  const WorldPoint here = agent->place();
  if (DistanceBetween(here, mind.home) > kPost_m) {
    mind.goal.reset();
    return GoTo(agent, world, mind.home, agent->species->cruise_mps);
  }
  // It looks another way from time to time.
  if (!mind.goal.has_value() || world->episode_step >= mind.goal_until) {
    mind.goal = Ahead(mind.home, mind.random.Uniform(-M_PI, M_PI), kLook_m);
    mind.goal_until = world->In(mind.random.Uniform(3.0, 6.0));
  }
  Steering steering = FaceTo(*agent, *mind.goal);
  KeepToHome(*agent, &steering);
  return steering;
}

}  // namespace latticeworld
