#ifndef LATTICEWORLD_SIMULATION_AGENTS_WAYS_PLACES_H_
#define LATTICEWORLD_SIMULATION_AGENTS_WAYS_PLACES_H_

#include <optional>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"

namespace latticeworld {

// What the pieces of behaviour trees share: where to go, and how to stand there.

// Shows the behaviour; when it was another one, goal and pause of that one are dropped.
void TakeUp(Agent* agent, Behaviour behaviour);

// Stands where it is; flyers and swimmers keep to that place and height.
Steering StandHere(const Agent& agent);
// Those that fly and swim are to keep to their home, against wind and drift.
void KeepToHome(const Agent& agent, Steering* steering);
// Turns on the spot until it faces the place; what cannot turn on the spot stands.
Steering FaceTo(const Agent& agent, WorldPoint place);

// A place between near_m and far_m from the center where it can stand, drawn from its own random
// stream; one that it can go straight to from `from` if some draws find any. nullopt: none found.
std::optional<WorldPoint> DrawPlace(Agent* agent, const Surroundings& world, WorldPoint center,
                                    WorldPoint from, double near_m, double far_m);

// The mind's goal, given up after a time that is ample for the way.
void SetGoal(Agent* agent, const Surroundings& world, WorldPoint goal, double speed_mps);
// Whether it is there or the time is over. It has a goal.
bool GoalDone(const Agent& agent, const Surroundings& world);
// Drops the goal and stands for a while.
void PauseFor(Agent* agent, const Surroundings& world, double low_s, double high_s);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_WAYS_PLACES_H_
