#ifndef LATTICEWORLD_SIMULATION_PROPS_BLOWS_H_
#define LATTICEWORLD_SIMULATION_PROPS_BLOWS_H_

#include <Eigen/Core>

#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

// What a blow does to something that stands on its base and bends there: trees and posts.

// Moment at its base when a body of that mass hits it at that speed [N m]: the elastic energy at
// the greatest lean equals the energy of the blow, so M = v sqrt(m k), whatever the height and the
// step. stiffness: [N m/rad].
double ImpactMoment(double mass_kg, double approach_mps, double stiffness_nmprad);
// The stiffness that such a blow meets when what stands has that one: the body that hits gives in,
// too, in proportion to its mass [N m/rad].
double StiffnessMet(double mass_kg, double stiffness_nmprad);
// Speed that the body keeps when what it hit breaks at that moment; the moment of its blow is no
// less.
double SpeedAfterBreaking(double mass_kg, double approach_mps, double stiffness_nmprad,
                          double moment_nm);

// Mass that a rigid body opposes to a blow at a point of it, along a unit direction [kg].
double MassMet(const BodySpec& spec, const BodyMotion& motion, const Eigen::Vector3d& point_m,
               const Eigen::Vector3d& direction);
// Whether a body is driven on as a whole: vehicles and legged robots are, and what stands upright
// by itself; stems, crates and the like are not.
bool IsDriven(const BodySpec& spec);
// Mass with which a body hits at a point: all of what is driven, MassMet of others [kg].
double HittingMass(const PhysicsWorld& physics, BodyId body, const Eigen::Vector3d& point_m,
                   const Eigen::Vector3d& direction);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_PROPS_BLOWS_H_
