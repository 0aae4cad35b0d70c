#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_AGENT_ROSTER_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_AGENT_ROSTER_H_

#include <map>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/ways/agent_grid.h"

namespace latticeworld {

// The agents of a run, found by their ids, names and bodies, and by where they are.
class AgentRoster {
 public:
  AgentRoster() = default;
  AgentRoster(const AgentRoster&) = delete;
  AgentRoster& operator=(const AgentRoster&) = delete;

  // agent: with an id and a name that no other has. The answer stays where it is until it is
  // erased.
  Agent& Add(Agent agent);
  void Erase(AgentId id);
  void Clear();
  // The agent has that body from now on, instead of the one that it had.
  void SetBody(BodyId body, Agent* agent);

  const std::map<AgentId, Agent>& all() const { return agents_; }
  std::map<AgentId, Agent>& all() { return agents_; }
  const std::map<std::string, AgentId>& ids() const { return ids_; }  // by name
  // Errors: NOT_FOUND.
  Result<Agent*> Find(const std::string& name);
  // The agent whose body it is; 0: nobody's.
  AgentId IdOfBody(BodyId body) const;

  // Finds who is where, and who takes part in a step.
  void BeginStep(double world_size_m);
  // Who takes part in this step, by id; nobody any more once somebody came or went.
  const std::vector<Agent*>& in_step() const { return in_step_; }
  // Finds who is where, for those who ask before the first step.
  void FindPlaces(double world_size_m) { places_.Rebuild(world_size_m, agents_); }
  // Who was where at the begin of the step; nobody once somebody went.
  const AgentGrid& places() const { return places_; }

  // Goes back to a copy of all(). Who is where is found by the next step.
  void Restore(const std::map<AgentId, Agent>& agents);
  // Adds all that their future depends on, but for their bodies, which the physics world adds.
  void AddTo(Digest* digest) const;

 private:
  std::map<AgentId, Agent> agents_;
  std::map<std::string, AgentId> ids_;  // by name
  std::map<BodyId, AgentId> agent_of_body_;
  std::vector<Agent*> in_step_;  // of agents_, by id; empty: made by the next step
  AgentGrid places_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_AGENT_ROSTER_H_
