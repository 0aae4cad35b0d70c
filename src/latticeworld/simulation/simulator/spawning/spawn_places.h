#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_SPAWN_PLACES_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_SPAWN_PLACES_H_

#include <optional>
#include <string>

#include "latticeworld/common/random.h"
#include "latticeworld/common/result.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld/simulation/simulator/running_world.h"

namespace latticeworld {

// "(3.5, -2)": a place in messages.
std::string TextOf(WorldPoint place);

// Returns where an agent of the species can begin: the request's place, or one drawn from its
// region. It is legal by the rules of the scene and free of agents, props and trees that lie or
// fall. Errors: see Simulator::Spawn.
Result<WorldPoint> PlaceFor(const SpawnRequest& request, const Species& species,
                            const RunningWorld& world, RandomStream* random);
// Returns where a scene's agent begins: at its start. A scene is made for its categories' own
// bodies; one that is larger and does not fit there begins near it, the same in every episode, or
// at its start all the same where there is room for it nowhere.
WorldPoint PlaceToBegin(const AgentStart& start, const Species& species, const RunningWorld& world);
// Returns where an agent that died can come back: at its start, or near it, drawn from its own
// random stream. None: something is in the way everywhere that was tried.
std::optional<WorldPoint> PlaceToRespawn(const RunningWorld& world, Agent* agent);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_SPAWN_PLACES_H_
