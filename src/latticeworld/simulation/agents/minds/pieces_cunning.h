#ifndef LATTICEWORLD_SIMULATION_AGENTS_MINDS_PIECES_CUNNING_H_
#define LATTICEWORLD_SIMULATION_AGENTS_MINDS_PIECES_CUNNING_H_

#include <optional>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"

namespace latticeworld {

// Pieces of behaviour trees (behaviour_tree.h) for hunting in a pack and from a hiding place.

// Chooses as ChoosePrey does (pieces_hunt.h); without prey of its own, that of a mate within call
// who sees it.
void ChooseSharedPrey(Agent* agent, Surroundings* world);
// Others of its team near the target are after the same one.
bool HuntsInPack(const Agent& agent, const Surroundings& world);
// Takes its place of a ring around the target, each of the pack at another bearing; nullopt once
// all are in place, one has begun to strike, or it has lasted too long: time to close in.
std::optional<Steering> Encircle(Agent* agent, Surroundings* world);

// Chooses, as ChoosePrey does, who comes within a few strides of the hiding place or strikes it;
// until then it lets everybody pass.
void ChooseVictim(Agent* agent, Surroundings* world);
// Goes to a place near a road or its home that trees, buildings or the relief hide from most of
// what lies around, and waits there.
std::optional<Steering> Ambush(Agent* agent, Surroundings* world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_MINDS_PIECES_CUNNING_H_
