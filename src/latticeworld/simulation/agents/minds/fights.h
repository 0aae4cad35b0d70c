#ifndef LATTICEWORLD_SIMULATION_AGENTS_MINDS_FIGHTS_H_
#define LATTICEWORLD_SIMULATION_AGENTS_MINDS_FIGHTS_H_

#include <string>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"

namespace latticeworld {

// Gap between the sides of two bodies as upright cylinders [m]; below 0 they overlap. One above the
// other's height is as far away as it is above.
double GapBetween(const Agent& agent, const Agent& other);

// Whether its kind strikes at all.
bool CanStrike(const Agent& agent);
// Whether a blow of the agent would land on the other: within its reach and in front of it.
bool IsWithinReach(const Agent& agent, const Agent& other);
bool Faces(const Agent& agent, WorldPoint place);

// Takes hit points from the victim; tells hit (by: the agent or thing that did it; may be empty)
// and, when none are left, died. The dead are harmed no more.
void Harm(Agent* victim, double hit_points, const std::string& by, Surroundings* world);
// What becomes of who has no hit points left; tells died.
void Die(Agent* victim, const std::string& by, Surroundings* world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_MINDS_FIGHTS_H_
