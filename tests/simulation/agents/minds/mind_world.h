#ifndef LATTICEWORLD_TESTS_SIMULATION_AGENTS_MINDS_MIND_WORLD_H_
#define LATTICEWORLD_TESTS_SIMULATION_AGENTS_MINDS_MIND_WORLD_H_

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"
#include "latticeworld/simulation/agents/ways/agent_grid.h"
#include "latticeworld/simulation/agents/ways/path_finder.h"
#include "simulation/test_scene.h"

namespace latticeworld {

// Minds without bodies to speak of: agents go as they steer, at once and through everything, so
// that what a test sees is what they decided. Fights are real.
class MindWorld {
 public:
  explicit MindWorld(const TestScene& scene);
  ~MindWorld();

  // Of a built-in species, at a place, on the ground, standing.
  Agent& Add(const std::string& species, int team, double x_m, double y_m,
             double heading_rad = 0.0);
  void Remove(AgentId id);

  // What they think with at this moment.
  Surroundings& Now();
  // One look around of the agent.
  void Look(Agent* agent);
  // Everybody thinks by a policy, fights and goes, ten times a second.
  void Run(double seconds, const std::map<AgentId, std::string>& policies);

  double DistanceOf(const Agent& a, const Agent& b) const;
  int Count(EventKind kind, const std::string& agent) const;

  Atmosphere atmosphere;
  SceneChanges changes;
  std::vector<Event> events;
  std::map<AgentId, Agent> agents;
  std::uint64_t step = 0;
  double pursuit_distance_m = 25.0;

 private:
  void Go(Agent* agent, double seconds);

  std::shared_ptr<const Scene> scene_;
  SurfaceTable surfaces_;
  GustField gusts_;
  PathFinder paths_;
  AgentGrid near_;
  std::unique_ptr<PhysicsWorld> physics_;
  std::unique_ptr<Surroundings> now_;
  AgentId last_ = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_SIMULATION_AGENTS_MINDS_MIND_WORLD_H_
