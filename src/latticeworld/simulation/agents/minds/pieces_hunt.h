#ifndef LATTICEWORLD_SIMULATION_AGENTS_MINDS_PIECES_HUNT_H_
#define LATTICEWORLD_SIMULATION_AGENTS_MINDS_PIECES_HUNT_H_

#include <optional>
#include <string>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/behaviour_tree.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"

namespace latticeworld {

// Pieces of behaviour trees (behaviour_tree.h) that go after others. An agent's target is in its
// Mind; what it does about it rests on what it perceived of it, never on where it really is.

// Decides whom the agent is after: keeps, changes or drops mind.target.
using Chooser = void (*)(Agent* agent, Surroundings* world);
// The piece, as long as the chooser leaves it a target. Tells pursued when the target is another
// one than before.
Piece WithTarget(std::string name, Chooser choose, Piece piece);

// The nearest enemy that it sees within the pursuit distance, or who strikes it; kept until it is
// dead, forgotten or one and a half times as far away.
void ChoosePrey(Agent* agent, Surroundings* world);
// The same for who comes as near as a few strides, and for who strikes it.
void ChooseAssailant(Agent* agent, Surroundings* world);
// The same for who comes near its home; dropped as soon as it is away from there, or the agent is.
void ChooseIntruder(Agent* agent, Surroundings* world);

// Turns to the target that it can reach, and strikes.
std::optional<Steering> Attack(Agent* agent, Surroundings* world);
// Runs to where it sees the target, or saw it some seconds ago at most.
std::optional<Steering> Pursue(Agent* agent, Surroundings* world);
// Runs to where the target will be when both have arrived there.
std::optional<Steering> Intercept(Agent* agent, Surroundings* world);
// Goes to where it last saw the target and looks around there; in the end it gives it up.
std::optional<Steering> Search(Agent* agent, Surroundings* world);
// Goes and looks where it heard an enemy that it does not see.
std::optional<Steering> LookIntoNoise(Agent* agent, Surroundings* world);
// Stands at its home and looks around; goes back there from elsewhere.
std::optional<Steering> Guard(Agent* agent, Surroundings* world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_MINDS_PIECES_HUNT_H_
