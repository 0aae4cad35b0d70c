#ifndef LATTICEWORLD_SIMULATION_AGENTS_BODIES_DRIVES_H_
#define LATTICEWORLD_SIMULATION_AGENTS_BODIES_DRIVES_H_

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"

namespace latticeworld {

// One a plan: from agent.driven to its body, for the next step.

void DriveWheels(const Agent& agent, PhysicsWorld* physics);
// A trotting quadruped; also stands, falls, and gets up again.
void DriveQuadruped(Agent* agent, Surroundings* world);
// Bipeds and grazers. What was knocked over lies until it gets up; what is dead falls.
void DriveLegs(Agent* agent, Surroundings* world);
void DriveWings(const Agent& agent, const Surroundings& world);
void DriveFins(const Agent& agent, const Surroundings& world);

// Lays the agent down as fallen, stops what drives it, and tells knocked_over.
void FallOver(Agent* agent, Surroundings* world);
// While it is down: true when it has lain still for as long as its species takes to get up.
bool HasLainStill(Agent* agent, const Surroundings& world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_BODIES_DRIVES_H_
