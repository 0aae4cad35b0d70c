#ifndef LATTICEWORLD_SIMULATION_AGENTS_MINDS_HERD_H_
#define LATTICEWORLD_SIMULATION_AGENTS_MINDS_HERD_H_

#include <Eigen/Core>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"

namespace latticeworld {

// Returns where its herd draws an agent, map frame: away from those that stand too close, along
// with those that go somewhere, and towards the middle of its nearest once they are far (Reynolds
// 1987, Flocks, herds and schools: a distributed behavioral model, SIGGRAPH '87: separation before
// alignment before cohesion, until the length of 1 is spent). Length 0: it is well where it is ..
// 1: it should go at once.
Eigen::Vector2d Flocking(const Agent& agent, const Surroundings& world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_MINDS_HERD_H_
