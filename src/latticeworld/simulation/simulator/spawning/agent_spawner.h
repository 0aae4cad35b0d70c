#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_AGENT_SPAWNER_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_AGENT_SPAWNER_H_

#include <cstdint>
#include <string>

#include "latticeworld/common/random.h"
#include "latticeworld/common/result.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld/simulation/simulator/running_world.h"

namespace latticeworld {

// Brings agents into a world: those of the scene and those that are asked for. It gives out their
// ids and draws their places. Plain data, to copy into a snapshot.
class AgentSpawner {
 public:
  // seed: of the episode.
  explicit AgentSpawner(std::uint64_t seed) : random_(seed, "spawn") {}

  // The agents of the scene begin at their starts, or where PlaceToBegin says.
  void SpawnStarts(RunningWorld* world);
  // Brings in the agent that is asked for and tells spawned. The answer is its name. A refused
  // request leaves everything as it was, the random stream too. Errors: see Simulator::Spawn.
  Result<std::string> Spawn(const SpawnRequest& request, RunningWorld* world);
  // Adds all that its future depends on.
  void AddTo(Digest* digest) const;

 private:
  // An agent that begins now. policy: its own; may be empty.
  Agent& Begin(const AgentStart& start, const Species& species, const std::string& policy,
               RunningWorld* world);

  AgentId last_agent_ = 0;
  RandomStream random_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_AGENT_SPAWNER_H_
