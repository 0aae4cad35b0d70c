#include "latticeworld/simulation/agents/hostility.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/sensing/line_of_sight.h"
#include "latticeworld/sensing/weather_effects.h"
#include "latticeworld/simulation/agents/behaviours.h"
#include "latticeworld/simulation/agents/species.h"
#include "latticeworld/simulation/agents/steering.h"

namespace latticeworld {
namespace {

constexpr double kUnseen_s = 4.0;              // gives up after so long without sight
constexpr double kGiveUpDistanceFactor = 1.5;  // times the pursuit distance
constexpr double kFacing_rad = 0.6;            // strikes only what is in front of it

Eigen::Vector3d EyeOf(const Agent& agent) {
  return agent.motion.position_m +
         SpeciesOf(agent.category).eye_height_m * Eigen::Vector3d::UnitZ();
}

bool IsPrey(const Agent& hunter, const Agent& other) {
  return other.team == 1 && other.team != hunter.team && other.alive();
}

// Gap between the sides of two bodies; infinite where one is above the other's reach.
double GapTo(const Agent& agent, const Agent& other) {
  const double flat_m =
      DistanceBetween(agent.place(), other.place()) - agent.radius_m - other.radius_m;
  const double above_m = other.motion.position_m.z() - agent.motion.position_m.z() -
                         SpeciesOf(agent.category).height_m;
  const double below_m = agent.motion.position_m.z() - other.motion.position_m.z() -
                         SpeciesOf(other.category).height_m;
  return std::max({flat_m, above_m, below_m});
}

void LookForPrey(Agent* agent, Surroundings* world) {
  double nearest_m = world->pursuit_distance_m;
  for (const auto& [id, other] : world->agents) {
    if (!IsPrey(*agent, other)) continue;
    const double distance_m = (other.motion.position_m - agent->motion.position_m).norm();
    if (distance_m > nearest_m || !Sees(*agent, other, *world, nearest_m)) continue;
    nearest_m = distance_m;
    agent->mind.target = id;
  }
  if (agent->mind.target == 0) return;
  const Agent& prey = world->agents.at(agent->mind.target);
  agent->mind.target_seen_at = prey.place();
  agent->mind.target_seen_step = world->episode_step;
  world->Tell(EventKind::kPursued, *agent, prey.name);
}

void Strike(Agent* agent, Agent* prey, Surroundings* world) {
  const Species& species = SpeciesOf(agent->category);
  agent->mind.next_blow = world->In(species.attack_pause_s);
  prey->hit_points = std::max(0.0, prey->hit_points - species.attack_damage);
  world->Tell(EventKind::kAttacked, *agent, prey->name);
  world->Tell(EventKind::kHit, *prey, agent->name);
  if (!prey->alive()) world->Tell(EventKind::kDied, *prey, agent->name);
}

// Turns on the spot until it faces the prey.
Steering FaceTo(const Agent& agent, WorldPoint place) {
  Steering steering;
  steering.heading_rad = HeadingTo(agent.place(), place);
  const double error_rad = WrapAngle(steering.heading_rad - agent.motion.yaw_rad());
  steering.speed_mps = std::abs(error_rad) < 0.5 * kFacing_rad ? 0.0 : 0.05;
  return steering;
}

}  // namespace

bool Sees(const Agent& agent, const Agent& other, const Surroundings& world, double distance_m) {
  const Eigen::Vector3d from = EyeOf(agent), to = EyeOf(other);
  if ((to - from).norm() > std::min(distance_m, SightRange(world.atmosphere))) return false;
  return HasLineOfSight(world.scene, from, to);
}

std::optional<Steering> Hunt(Agent* agent, Surroundings* world) {
  Mind& mind = agent->mind;
  const auto forget = [&mind] {
    mind.target = 0;
    mind.goal.reset();
  };
  if (mind.target != 0) {
    const auto found = world->agents.find(mind.target);
    if (found == world->agents.end() || !IsPrey(*agent, found->second)) forget();
  }
  if (mind.target == 0) LookForPrey(agent, world);
  if (mind.target == 0) return std::nullopt;

  Agent& prey = world->agents.at(mind.target);
  const double farthest_m = kGiveUpDistanceFactor * world->pursuit_distance_m;
  const bool seen = Sees(*agent, prey, *world, farthest_m);
  if (seen) {
    mind.target_seen_at = prey.place();
    mind.target_seen_step = world->episode_step;
  } else if (world->episode_step - mind.target_seen_step > world->StepsIn(kUnseen_s)) {
    forget();
    return std::nullopt;
  }

  const Species& species = SpeciesOf(agent->category);
  if (seen && species.attack_reach_m > 0.0 && GapTo(*agent, prey) <= species.attack_reach_m) {
    agent->behaviour = Behaviour::kAttack;
    const double error_rad =
        WrapAngle(HeadingTo(agent->place(), prey.place()) - agent->motion.yaw_rad());
    if (world->episode_step >= mind.next_blow && std::abs(error_rad) < kFacing_rad) {
      Strike(agent, &prey, world);
    }
    return FaceTo(*agent, prey.place());
  }
  agent->behaviour = Behaviour::kPursue;
  return Travel(agent, world, mind.target_seen_at, species.top_speed_mps);
}

}  // namespace latticeworld
