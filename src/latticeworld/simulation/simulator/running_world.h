#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_RUNNING_WORLD_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_RUNNING_WORLD_H_

#include <cstdint>
#include <memory>
#include <string>

#include "latticeworld/simulation/agents/minds/surroundings.h"
#include "latticeworld/simulation/agents/ways/path_finder.h"
#include "latticeworld/simulation/simulation_clock.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld/simulation/simulator/agent_roster.h"
#include "latticeworld/simulation/simulator/dynamic_scene.h"
#include "latticeworld/simulation/simulator/event_log.h"
#include "latticeworld/simulation/simulator/map_state.h"
#include "latticeworld/simulation/simulator/running_weather.h"

namespace latticeworld {

// What there is in a run at a moment: time, events, ways, the scene that moves, weather, maps and
// agents. It decides nothing: types of their own, which work on it, decide who spawns, strays,
// collides or follows which policy.
struct RunningWorld {
  // Nothing runs until BeginEpisode. scene: not null. options: valid.
  RunningWorld(std::shared_ptr<const Scene> scene, const SimulatorOptions& options);
  RunningWorld(const RunningWorld&) = delete;
  RunningWorld& operator=(const RunningWorld&) = delete;

  // Goes back to the scene's props, trees and weather, without agents, and to step 0 of the
  // episode. Tells of the weather where it was another.
  void BeginEpisode(std::uint64_t episode_seed);

  // What agents think with at this moment.
  Surroundings ForAgents();
  // The name of the agent, prop or felled tree ("tree_7") that the body is of; "": of nobody.
  std::string NameOf(BodyId body) const;
  // Takes an agent and its body out of the world, untold.
  void Erase(AgentId id);

  const std::shared_ptr<const Scene> scene;
  const SimulatorOptions options;
  std::uint64_t seed = 0;  // of the episode
  SimulationClock clock;
  EventLog events;
  // Kept over episodes: what it answers depends on the changes that it is told alone.
  PathFinder paths;
  DynamicScene dynamic_scene;
  RunningWeather weather;
  MapState map;
  AgentRoster agents;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_RUNNING_WORLD_H_
