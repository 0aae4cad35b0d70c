#include "latticeworld/simulation/simulator/spawning/respawning.h"

#include <optional>

#include "latticeworld/simulation/simulator/spawning/embodiment.h"
#include "latticeworld/simulation/simulator/spawning/spawn_places.h"

namespace latticeworld {
namespace {

constexpr std::uint64_t kTurnsBetweenTries = 10;  // before it looks for a place again

// Whether an agent looks for a place to come back to in this step.
bool IsDue(const Agent& agent, const SimulationClock& clock) {
  if (!clock.HasTurn(agent.id) || agent.alive() || agent.species->respawn_s <= 0.0) return false;
  const std::uint64_t due = agent.died_at + clock.StepsIn(agent.species->respawn_s);
  return clock.episode_step() >= due &&
         (clock.episode_step() - due) / clock.turn_steps() % kTurnsBetweenTries == 0;
}

}  // namespace

void RespawnAgents(const StrayWatch& strays, RunningWorld* world) {
  for (Agent* agent : world->agents.in_step()) {
    if (!IsDue(*agent, world->clock) || strays.IsFrozen(agent->id)) continue;
    const std::optional<WorldPoint> place = PlaceToRespawn(*world, agent);
    if (!place.has_value()) continue;
    Embody(*place, agent, world);
    world->ForAgents().Tell(EventKind::kRespawned, *agent, "");
  }
}

}  // namespace latticeworld
