#ifndef LATTICEWORLD_SIMULATION_AGENTS_MINDS_SURROUNDINGS_H_
#define LATTICEWORLD_SIMULATION_AGENTS_MINDS_SURROUNDINGS_H_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/scene_changes.h"
#include "latticeworld/scene/surface_table.h"
#include "latticeworld/scene/weather/water_depth.h"
#include "latticeworld/scene/weather/wind.h"
#include "latticeworld/simulation/agents/agent.h"

namespace latticeworld {

class AgentGrid;
class PathFinder;

// What agents think with: the world around them, and how they tell what they did.
struct Surroundings {
  const Scene& scene;
  const SceneChanges& changes;   // trees that lie or fall
  std::uint64_t map_version;     // of WorldState
  const Atmosphere& atmosphere;  // of the moment
  const SurfaceTable& surfaces;
  const GustField& gusts;
  Eigen::Vector2d drift_m;  // of the air since the episode began
  PathFinder& paths;
  const AgentGrid& near;  // who is where, at the begin of the step
  std::map<AgentId, Agent>& agents;
  PhysicsWorld& physics;
  std::vector<Event>& events;
  double step_s;
  double pursuit_distance_m;
  std::uint64_t step;          // for events
  std::uint64_t episode_step;  // for timers

  double WaterDepthAt(WorldPoint place) const {
    return latticeworld::WaterDepthAt(*scene.terrain, atmosphere, place);
  }
  Eigen::Vector3d WindAt(WorldPoint place) const {
    return gusts.WindAt(atmosphere, drift_m, place);
  }
  std::uint64_t StepsIn(double seconds) const {
    return static_cast<std::uint64_t>(seconds / step_s + 0.5);
  }
  std::uint64_t In(double seconds) const { return episode_step + StepsIn(seconds); }
  // Of the bed and what stands on it: the water's surface, else the ground [m].
  double SurfaceHeightAt(WorldPoint place) const {
    return scene.terrain->ground.HeightAt(place) + WaterDepthAt(place);
  }
  // nullptr: there is none of that id, or it is dead.
  const Agent* FindLiving(AgentId id) const {
    const auto found = agents.find(id);
    return found == agents.end() || !found->second.alive() ? nullptr : &found->second;
  }
  void Tell(EventKind kind, const Agent& agent, const std::string& other) {
    events.push_back({step, kind, agent.name, other, agent.motion.position_m});
  }
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_MINDS_SURROUNDINGS_H_
