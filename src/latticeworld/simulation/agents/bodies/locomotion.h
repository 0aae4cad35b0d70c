#ifndef LATTICEWORLD_SIMULATION_AGENTS_BODIES_LOCOMOTION_H_
#define LATTICEWORLD_SIMULATION_AGENTS_BODIES_LOCOMOTION_H_

#include <vector>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"

namespace latticeworld {

// The command within what the species can do.
VelocityCommand ClampToLimits(const Species& species, const VelocityCommand& command);

// Turns a wanted velocity into wheel rates, steps, thrust or strokes for the next step; joints that
// are commanded follow their commands instead. A dead or fallen agent drives nothing; gravity,
// water and wind still act on it, and what can gets up again. Harm by deep water is done here
// (drowned, died).
void Drive(Agent* agent, const VelocityCommand& wanted, Surroundings* world);

// A blow that gives it an impulse [N s, map frame] at a height above its base: acts on its body,
// and knocks it over where its species says so (tells knocked_over).
void TakeBlow(Agent* agent, const Eigen::Vector3d& impulse_ns, double height_m,
              Surroundings* world);
// The same of a collision, whose impulse its body has had already.
void FeelCollision(Agent* agent, const Eigen::Vector3d& impulse_ns, double height_m,
                   Surroundings* world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_BODIES_LOCOMOTION_H_
