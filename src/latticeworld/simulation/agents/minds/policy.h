#ifndef LATTICEWORLD_SIMULATION_AGENTS_MINDS_POLICY_H_
#define LATTICEWORLD_SIMULATION_AGENTS_MINDS_POLICY_H_

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"

namespace latticeworld {

class BehaviourPiece;

// How an agent decides. Without state: what it has to remember is in the agent's Mind.
class Policy {
 public:
  virtual ~Policy() = default;
  // Sets the agent's behaviour and mind, and answers what it steers for until its next thought.
  virtual Steering Decide(Agent* agent, Surroundings* world) const = 0;
  // The behaviour tree that it asks, for pictures; nullptr: it has none.
  virtual const BehaviourPiece* tree() const { return nullptr; }
};

// nullptr: there is none of that name. The built-in ones are listed in docs/behaviours.md.
const Policy* FindPolicy(std::string_view name);
std::vector<std::string> PolicyNames();  // sorted
// The one that agents of a category in a state follow unless told otherwise.
std::string UsualPolicy(AgentCategory category, AgentState state);

// Adds a policy of a program's own, before any simulator is made; not thread safe. False: the name
// is taken or empty.
bool RegisterPolicy(std::string name, std::unique_ptr<const Policy> policy);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_MINDS_POLICY_H_
