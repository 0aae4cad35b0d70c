#ifndef LATTICEWORLD_SIMULATION_AGENTS_MINDS_BEHAVIOUR_TREE_H_
#define LATTICEWORLD_SIMULATION_AGENTS_MINDS_BEHAVIOUR_TREE_H_

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"

namespace latticeworld {

// A piece of a behaviour tree (Colledanchise and Oegren 2018). A reactive tree: at every thought it
// is asked anew from its root; pieces have no state of their own, what lasts is in the Mind.
class BehaviourPiece {
 public:
  virtual ~BehaviourPiece() = default;
  // What the agent steers for; nullopt: not now, let another piece decide.
  virtual std::optional<Steering> Try(Agent* agent, Surroundings* world) const = 0;
  // "first of", "pursue", "when hurt": for the picture in the docs.
  virtual std::string name() const = 0;
  virtual std::vector<const BehaviourPiece*> children() const { return {}; }
};
using Piece = std::unique_ptr<const BehaviourPiece>;

using Condition = bool (*)(const Agent& agent, const Surroundings& world);
using Action = std::optional<Steering> (*)(Agent* agent, Surroundings* world);

// The first of the pieces that decides.
Piece FirstOf(std::vector<Piece> pieces);
// The piece, as long as the gate lets it; the gate may change the agent's mind first.
using Gate = std::function<bool(Agent* agent, Surroundings* world)>;
Piece Gated(std::string name, Gate gate, Piece piece);
// The piece, as long as the condition holds.
Piece When(std::string name, Condition condition, Piece piece);
Piece Do(std::string name, Action action);

// The tree as a Mermaid flow chart: one node a piece, in the order in which they are asked.
std::string DrawTree(const BehaviourPiece& root);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_MINDS_BEHAVIOUR_TREE_H_
