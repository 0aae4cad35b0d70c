#include "latticeworld/simulation/agents/minds/pieces_fear.h"

#include <limits>

#include "latticeworld/simulation/agents/minds/perception.h"
#include "latticeworld/simulation/agents/minds/targets.h"
#include "latticeworld/simulation/agents/ways/agent_grid.h"
#include "latticeworld/simulation/agents/ways/places.h"
#include "latticeworld/simulation/agents/ways/steering.h"

namespace latticeworld {
namespace {

constexpr double kThreat_m = 8.0;  // nearer than this, others are a threat
constexpr double kAlarmed_s = 4.0;
constexpr double kJustHit_s = 0.5;
constexpr double kSafe_m = 20.0;  // runs no further than this from a threat

// Takes the alarm over from one of its kind beside it that flees from something that it perceived
// itself a moment ago; what is told on grows old, so that an alarm dies down.
void HeedTheHerd(Agent* agent, const Surroundings& world) {
  constexpr double kBeside_m = 8.0, kFresh_s = 1.5;
  const Sighting* told = nullptr;
  world.near->ForEachNear(agent->place(), kBeside_m, [&](const Agent& other) {
    if (told != nullptr || other.id == agent->id || other.behaviour != Behaviour::kFlee) return;
    if (other.species != agent->species) return;
    const Sighting* threat =
        NearestKnown(other, world, std::numeric_limits<double>::infinity(), kFresh_s);
    if (threat == nullptr) return;
    // The agent thinks for itself about what it perceived as lately.
    const Sighting* own = MemoryOf(*agent, threat->who);
    if (own == nullptr || own->step < threat->step) told = threat;
  });
  if (told == nullptr) return;
  RememberHearsay(agent, *told);
  agent->mind.alarmed_until = world.In(kAlarmed_s);
}

}  // namespace

Steering RunFrom(Agent* agent, Surroundings* world, WorldPoint danger) {
  constexpr double kRun_m = 8.0;
  constexpr double kTurns_rad[] = {0.0, 0.5, 1.0, 1.6, 2.2};
  const WorldPoint here = agent->place();
  const double away_rad = HeadingTo(danger, here);
  const auto way_rad =
      FirstClearHeading(away_rad, kTurns_rad, &agent->mind.turn_side, [&](double heading_rad) {
        return CanGo(*world, *agent, here, Ahead(here, heading_rad, kRun_m));
      });
  if (!way_rad.has_value()) return FaceTo(*agent, danger);
  return GoTo(agent, world, Ahead(here, *way_rad, kRun_m), agent->species->top_speed_mps);
}

std::optional<Steering> Flee(Agent* agent, Surroundings* world) {
  constexpr double kForgotten_s = 6.0;
  Mind& mind = agent->mind;
  if (agent->team == 0) HeedTheHerd(agent, *world);
  if (WasHit(*agent, *world, kJustHit_s) ||
      NearestKnown(*agent, *world, kThreat_m, 1.0) != nullptr) {
    mind.alarmed_until = world->In(kAlarmed_s);
  }
  if (world->episode_step >= mind.alarmed_until) return std::nullopt;
  const Sighting* threat = NearestKnown(*agent, *world, kSafe_m, kForgotten_s);
  if (threat == nullptr) return std::nullopt;
  TakeUp(agent, Behaviour::kFlee);
  return RunFrom(agent, world, PlaceOf(*threat));
}

bool IsHurt(const Agent& agent, const Surroundings&) {
  return agent.hit_points < agent.species->hurt_share * agent.species->hit_points;
}

std::optional<Steering> Retreat(Agent* agent, Surroundings* world) {
  constexpr double kRemembered_s = 6.0;
  const Sighting* threat = NearestKnown(*agent, *world, kSafe_m, kRemembered_s);
  if (threat == nullptr) return std::nullopt;
  TakeUp(agent, Behaviour::kRetreat);
  return RunFrom(agent, world, PlaceOf(*threat));
}

std::optional<Steering> Withdraw(Agent* agent, Surroundings* world) {
  constexpr double kWithdraw_s = 3.0;
  Mind& mind = agent->mind;
  const bool struck = agent->next_blow > world->episode_step;
  if (agent->behaviour == Behaviour::kAttack && struck) {
    mind.alarmed_until = world->In(kWithdraw_s);
  }
  if (world->episode_step >= mind.alarmed_until) return std::nullopt;
  const Sighting* target = MemoryOf(*agent, mind.target);
  if (target == nullptr) return std::nullopt;
  TakeUp(agent, Behaviour::kRetreat);
  return RunFrom(agent, world, PlaceOf(*target));
}

}  // namespace latticeworld
