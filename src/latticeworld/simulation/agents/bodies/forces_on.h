#ifndef LATTICEWORLD_SIMULATION_AGENTS_BODIES_FORCES_ON_H_
#define LATTICEWORLD_SIMULATION_AGENTS_BODIES_FORCES_ON_H_

#include <Eigen/Core>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"

namespace latticeworld {

// What air, water and ground do to an agent, whatever it drives with.

// Drag of air of that velocity on a body of that velocity [N].
Eigen::Vector3d AirDrag(double drag_area_m2, const Eigen::Vector3d& wind_mps,
                        const Eigen::Vector3d& velocity_mps);

// Wind pushes what stands on the ground; what is light or broad moves.
void BlowOn(const Agent& agent, const Surroundings& world);

// Buoyancy and drag of water on its body. Harm where it is deeper in it than its species bears.
void Float(Agent* agent, Surroundings* world);

// Share of its top speed that a walker keeps in snow of that depth.
double SpeedInSnow(double depth_m);

// A horizontal velocity without what leads up ground that is steeper than the species climbs. The
// ground is no matter to what stands on something above it.
Eigen::Vector3d WithinSlope(const Agent& agent, const Surroundings& world,
                            const Eigen::Vector3d& velocity_mps);

// Torque about the vertical that turns an upright body at that rate.
void TurnTo(const Agent& agent, double yaw_rate_radps, PhysicsWorld* physics);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_BODIES_FORCES_ON_H_
