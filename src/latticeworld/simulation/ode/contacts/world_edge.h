#ifndef LATTICEWORLD_SIMULATION_ODE_CONTACTS_WORLD_EDGE_H_
#define LATTICEWORLD_SIMULATION_ODE_CONTACTS_WORLD_EDGE_H_

#include "latticeworld/simulation/ode/body/ode_body.h"
#include "latticeworld/simulation/ode/island_group.h"

namespace latticeworld {

// Notes in its group where a body touches the edge of the world, which is half_m from its middle.
// The edge is a soft wall. It acts at the height of the centre, so that it stops the body without
// tipping it. What is so fast that it would go far beyond the edge in this step is stopped before
// it.
void TouchEdge(double half_m, OdeBody* body, double step_s, IslandGroup* group);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_CONTACTS_WORLD_EDGE_H_
