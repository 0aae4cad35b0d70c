#ifndef LATTICEWORLD_SIMULATION_AGENTS_MINDS_SURROUNDINGS_H_
#define LATTICEWORLD_SIMULATION_AGENTS_MINDS_SURROUNDINGS_H_

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/scene_changes.h"
#include "latticeworld/scene/surface_table.h"
#include "latticeworld/scene/weather/water_depth.h"
#include "latticeworld/scene/weather/wind.h"
#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/simulation_clock.h"

namespace latticeworld {

class AgentGrid;
class PathFinder;

// What agents think with: the world around them, and how they tell what they did. Whoever makes one
// sets every field by its name; no pointer is null then, and what they point at outlives it.
struct Surroundings {
  const Scene* scene = nullptr;
  const SceneChanges* changes = nullptr;   // trees that lie or fall
  std::uint64_t map_version = 0;           // of WorldState
  const Atmosphere* atmosphere = nullptr;  // of the moment
  const SurfaceTable* surfaces = nullptr;
  const GustField* gusts = nullptr;
  Eigen::Vector2d drift_m = Eigen::Vector2d::Zero();  // of the air since the episode began
  PathFinder* paths = nullptr;
  const AgentGrid* near = nullptr;  // who is where, at the begin of the step
  std::map<AgentId, Agent>* agents = nullptr;
  PhysicsWorld* physics = nullptr;
  std::vector<Event>* events = nullptr;
  double step_s = 0.0;
  double pursuit_distance_m = 0.0;
  std::uint64_t step = 0;          // for events
  std::uint64_t episode_step = 0;  // for timers

  double WaterDepthAt(WorldPoint place) const {
    return latticeworld::WaterDepthAt(*scene->terrain, *atmosphere, place);
  }
  Eigen::Vector3d WindAt(WorldPoint place) const {
    return gusts->WindAt(*atmosphere, drift_m, place);
  }
  std::uint64_t StepsIn(double seconds) const { return WholeSteps(seconds, step_s); }
  std::uint64_t In(double seconds) const { return episode_step + StepsIn(seconds); }
  // Returns the height of the water's surface, or of the ground where it is dry [m].
  double SurfaceHeightAt(WorldPoint place) const {
    return scene->terrain->ground.HeightAt(place) + WaterDepthAt(place);
  }
  // nullptr: there is none of that id, or it is dead.
  const Agent* FindLiving(AgentId id) const {
    const auto found = agents->find(id);
    return found == agents->end() || !found->second.alive() ? nullptr : &found->second;
  }
  void Tell(EventKind kind, const Agent& agent, const std::string& other) {
    Event event;
    event.step = step;
    event.kind = kind;
    event.agent = agent.name;
    event.other = other;
    event.position_m = agent.motion.position_m;
    events->push_back(std::move(event));
  }
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_MINDS_SURROUNDINGS_H_
