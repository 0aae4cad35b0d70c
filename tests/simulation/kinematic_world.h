#ifndef LATTICEWORLD_TESTS_SIMULATION_KINEMATIC_WORLD_H_
#define LATTICEWORLD_TESTS_SIMULATION_KINEMATIC_WORLD_H_

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/scene/weather/wind.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"
#include "latticeworld/simulation/agents/ways/agent_grid.h"
#include "latticeworld/simulation/agents/ways/path_finder.h"
#include "latticeworld/species/species_catalogue.h"
#include "simulation/test_scene.h"

namespace latticeworld {

// Agents that move exactly as their steering says, within the limits of their species: steering
// alone, without physics.
class KinematicWorld {
 public:
  explicit KinematicWorld(std::shared_ptr<const Scene> scene, std::uint64_t seed = 1);

  Agent& Add(const std::string& species, double x_m, double y_m, double heading_rad = 0.0);
  Surroundings World();
  // Steps for that long; steer is asked ten times a second for each living agent.
  using Steer = std::function<Steering(Agent*, Surroundings*)>;
  void Run(double seconds, const Steer& steer);

  std::map<AgentId, Agent>& agents() { return agents_; }
  PathFinder& paths() { return paths_; }
  SceneChanges& changes() { return changes_; }
  std::uint64_t& map_version() { return map_version_; }
  // Least distance between the sides of two agents so far [m]; below 0: they were in each other.
  double least_gap_m() const { return least_gap_m_; }

 private:
  void Move(Agent* agent);

  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<const SpeciesCatalogue> species_ = SpeciesCatalogue::BuiltIn();
  std::uint64_t seed_;
  SceneChanges changes_;
  std::uint64_t map_version_ = 0;
  SurfaceTable surfaces_;
  GustField gusts_;
  PathFinder paths_;
  AgentGrid near_;
  std::map<AgentId, Agent> agents_;
  std::unique_ptr<PhysicsWorld> physics_;  // without bodies
  std::vector<Event> events_;
  std::uint64_t step_ = 0;
  double least_gap_m_ = 1e9;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_SIMULATION_KINEMATIC_WORLD_H_
