#ifndef LATTICEWORLD_SIMULATION_AGENTS_BODIES_FOOTING_H_
#define LATTICEWORLD_SIMULATION_AGENTS_BODIES_FOOTING_H_

#include <memory>
#include <vector>

#include "latticeworld/scene/props/standing_props.h"
#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"

namespace latticeworld {

// What carries the feet of an agent around it: the ground, and the decks of bridges that it stands
// on or can step onto.
class Footing {
 public:
  // Holds for places within reach_m of the agent. world: outlives this, unchanged.
  Footing(const Surroundings& world, const Agent& agent, double reach_m);
  // [m], map frame.
  double HeightAt(WorldPoint place) const;

 private:
  const HeightField& ground_;
  std::shared_ptr<const StandingProps> props_;
  std::vector<const PropDeck*> decks_;
};

// Whether the agent's base is on a bridge, also where the deck is hardly above the ground.
bool StandsOnDeck(const Surroundings& world, const Agent& agent);

// Whether a bridge carries a body of that mass at the place, not nearer than margin_m to its edge.
bool IsCarried(const StandingProps& props, WorldPoint place, double margin_m, double mass_kg);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_BODIES_FOOTING_H_
