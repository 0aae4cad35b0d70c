#ifndef LATTICEWORLD_SIMULATION_AGENTS_BODIES_BODY_PLANS_H_
#define LATTICEWORLD_SIMULATION_AGENTS_BODIES_BODY_PLANS_H_

#include "latticeworld/simulation/body_spec.h"
#include "latticeworld/species/species.h"

namespace latticeworld {

// The bodies of each plan, as BodyOf answers them, without what they have in common.

// Wheels: differential left, right, castor; else front left, front right, rear left, rear right.
BodySpec VehicleBody(const Species& species);
// Links: 3 * leg + joint; legs front left, front right, rear left, rear right; joints hip roll, hip
// pitch, knee, all 0 in the nominal stance.
BodySpec QuadrupedBody(const Species& species);
BodySpec BipedBody(const Species& species);
BodySpec GrazerBody(const Species& species);
BodySpec FlyerBody(const Species& species);
BodySpec SwimmerBody(const Species& species);

// Returns the moments of inertia of a homogeneous box about its centre [kg m^2].
Eigen::Vector3d BoxInertia(double mass_kg, const Eigen::Vector3d& size_m);
BodyShape BoxShape(const Eigen::Vector3d& center_m, const Eigen::Vector3d& half_extents_m);
// A box as a body's only shape, the corners of which meet the ground.
void MakeBox(const Eigen::Vector3d& center_m, const Eigen::Vector3d& half_extents_m,
             BodySpec* body);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_BODIES_BODY_PLANS_H_
