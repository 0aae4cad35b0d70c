#include "latticeworld/simulation/agents/minds/fights.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/simulation/agents/bodies/locomotion.h"
#include "latticeworld/simulation/agents/minds/thinking.h"
#include "latticeworld/simulation/agents/ways/agent_grid.h"
#include "latticeworld/simulation/agents/ways/steering.h"

namespace latticeworld {
namespace {

constexpr double kFacing_rad = 0.6;  // strikes only what is in front of it

// The widest body that the species' schema allows, so that a look around misses none that is within
// reach [m].
constexpr double kWidest_m = 5.0;

Agent* NearestWithinReach(const Agent& agent, Surroundings* world) {
  AgentId nearest = 0;
  double nearest_gap_m = agent.species->attack_reach_m;
  const double radius_m = agent.species->radius_m + nearest_gap_m + kWidest_m;
  world->near->ForEachNear(agent.place(), radius_m, [&](const Agent& other) {
    if (!AreEnemies(agent.team, other.team) || !other.alive()) return;
    if (!IsWithinReach(agent, other)) return;
    const double gap_m = GapBetween(agent, other);
    if (nearest != 0 && gap_m >= nearest_gap_m) return;
    nearest_gap_m = gap_m;
    nearest = other.id;
  });
  return nearest == 0 ? nullptr : &world->agents->at(nearest);
}

Agent* ThoughtOfTarget(const Agent& agent, Surroundings* world) {
  const Agent* const target = world->FindLiving(agent.mind.steering.strike);
  return target != nullptr && IsWithinReach(agent, *target) ? &world->agents->at(target->id)
                                                            : nullptr;
}

// Returns the height of a blow above the victim's base [m]. What stands on wheels or four feet is
// struck low at its side: a blow pushes it away and seldom turns it over, as it would at the height
// of its back.
double BlowHeight(const Agent& agent, const Agent& victim) {
  const double share = victim.species->plan == BodyPlan::kBiped ? 0.8 : 0.3;
  return std::min(agent.species->eye_height_m, share * victim.species->height_m);
}

void Strike(Agent* agent, Agent* victim, Surroundings* world) {
  const Species& species = *agent->species;
  agent->next_blow = world->In(species.attack_pause_s);
  world->Tell(EventKind::kAttacked, *agent, victim->name);
  victim->mind.hit_by = agent->id;
  victim->mind.hit_at = world->episode_step;
  Harm(victim, species.attack_damage, agent->name, world);
  if (species.attack_impulse_ns <= 0.0) return;
  const double heading_rad = HeadingTo(agent->place(), victim->place());
  const Eigen::Vector3d direction(std::cos(heading_rad), std::sin(heading_rad), 0.0);
  TakeBlow(victim, species.attack_impulse_ns * direction, BlowHeight(*agent, *victim), world);
}

}  // namespace

double GapBetween(const Agent& agent, const Agent& other) {
  const double flat_m = DistanceBetween(agent.place(), other.place()) - agent.species->radius_m -
                        other.species->radius_m;
  const double rise_m = other.motion.position_m.z() - agent.motion.position_m.z();
  const double above_m = rise_m - agent.species->height_m;
  const double below_m = -rise_m - other.species->height_m;
  return std::max({flat_m, above_m, below_m});
}

bool CanStrike(const Agent& agent) {
  return agent.species->attack_reach_m > 0.0 && agent.species->attack_damage > 0.0;
}

bool Faces(const Agent& agent, WorldPoint place) {
  const double error_rad = WrapAngle(HeadingTo(agent.place(), place) - agent.motion.yaw_rad());
  return std::abs(error_rad) < kFacing_rad;
}

bool IsWithinReach(const Agent& agent, const Agent& other) {
  return GapBetween(agent, other) <= agent.species->attack_reach_m && Faces(agent, other.place());
}

void Harm(Agent* victim, double hit_points, const std::string& by, Surroundings* world) {
  if (!victim->alive()) return;
  victim->hit_points = std::max(0.0, victim->hit_points - hit_points);
  world->Tell(EventKind::kHit, *victim, by);
  if (!victim->alive()) Die(victim, by, world);
}

void Die(Agent* victim, const std::string& by, Surroundings* world) {
  victim->hit_points = 0.0;
  victim->died_at = world->episode_step;
  victim->behaviour = Behaviour::kDead;
  victim->strike_wanted = false;
  world->Tell(EventKind::kDied, *victim, by);
}

void Fight(Agent* agent, Surroundings* world) {
  if (agent->mind.steering.strike == 0 && !agent->strike_wanted) return;
  if (!agent->able() || !CanStrike(*agent)) {
    agent->strike_wanted = false;
    return;
  }
  if (world->episode_step < agent->next_blow) return;
  const bool commanded = std::exchange(agent->strike_wanted, false);
  Agent* victim = commanded ? NearestWithinReach(*agent, world) : ThoughtOfTarget(*agent, world);
  if (victim != nullptr) Strike(agent, victim, world);
}

}  // namespace latticeworld
