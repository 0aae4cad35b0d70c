#include "latticeworld/simulation/agents/minds/targets.h"

#include "latticeworld/simulation/agents/minds/perception.h"

namespace latticeworld {
namespace {

bool FliesOverHead(const Agent& agent, const Sighting& sighting, const Surroundings& world) {
  if (agent.species->plan == BodyPlan::kFlyer) return false;
  const Agent* const other = world.FindLiving(sighting.who);
  if (other == nullptr || other->species->plan != BodyPlan::kFlyer) return false;
  const double ground_m = world.scene->terrain->ground.HeightAt(PlaceOf(sighting));
  const double reach_m = agent.species->height_m + agent.species->attack_reach_m;
  return sighting.position_m.z() > ground_m + reach_m;
}

}  // namespace

WorldPoint PlaceOf(const Sighting& sighting) {
  return {sighting.position_m.x(), sighting.position_m.y()};
}

double AgeOf(const Sighting& sighting, const Surroundings& world) {
  return static_cast<double>(world.episode_step - sighting.step) * world.step_s;
}

const Sighting* NearestSeenEnemy(const Agent& agent, const Surroundings& world, double distance_m) {
  return NearestOf(agent, distance_m, [&](const Sighting& sighting) {
    return sighting.seen_now && AreEnemies(agent.team, sighting.team) &&
           !FliesOverHead(agent, sighting, world);
  });
}

const Sighting* Striker(const Agent& agent, const Surroundings& world) {
  constexpr double kFelt_s = 1.0;
  if (!WasHit(agent, world, kFelt_s)) return nullptr;
  const Sighting* sighting = MemoryOf(agent, agent.mind.hit_by);
  return sighting != nullptr && AreEnemies(agent.team, sighting->team) ? sighting : nullptr;
}

void KeepOrTakeTarget(Agent* agent, const Surroundings& world, double take_m, double farthest_m) {
  constexpr double kUponIt_m = 4.0;    // a target nearer than this is not left for a striker
  constexpr double kMuchNearer = 0.5;  // times as far: then another one is the better target
  Mind& mind = agent->mind;
  const auto range_to = [&](const Sighting& sighting) {
    return (sighting.position_m - agent->motion.position_m).norm();
  };
  const Sighting* target = MemoryOf(*agent, mind.target);
  if (target != nullptr && range_to(*target) > farthest_m) target = nullptr;
  if (target == nullptr || range_to(*target) > kUponIt_m) {
    if (const Sighting* striker = Striker(*agent, world)) target = striker;
  }
  const Sighting* seen = NearestSeenEnemy(*agent, world, take_m);
  if (target == nullptr) {
    target = seen;
  } else if (seen != nullptr && range_to(*seen) < kMuchNearer * range_to(*target)) {
    target = seen;
  }
  mind.target = target == nullptr ? 0 : target->who;
}

}  // namespace latticeworld
