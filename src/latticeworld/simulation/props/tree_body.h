#ifndef LATTICEWORLD_SIMULATION_PROPS_TREE_BODY_H_
#define LATTICEWORLD_SIMULATION_PROPS_TREE_BODY_H_

#include <Eigen/Core>

#include "latticeworld/scene/asset.h"
#include "latticeworld/scene/asset_physics.h"
#include "latticeworld/scene/scene_changes.h"
#include "latticeworld/simulation/physics_world.h"
#include "latticeworld/simulation/water_forces.h"

namespace latticeworld {

// The body of a tree that falls: base_link is where its stem leaves the ground, z along the stem.
// Others meet its stem; the ground holds up its foot, its stem and the boughs around the middle of
// its crown. The mass is that of PhysicsOf, three quarters of it in a stem that tapers as a
// paraboloid and the rest in the crown's ellipsoid.
BodySpec TreeBodyOf(const Asset& tree, const AssetPhysics& physics);
// Returns the buoyancy of a tree's body, by the volume of its wood.
Buoyancy TreeBuoyancyOf(const Asset& tree);

// Returns where such a body begins: on the tree's place, leaning by a few degrees along `direction`
// (unit, level) and falling on at that rate about its foot.
BodyMotion BeginningOfFall(const Asset& tree, const Eigen::Vector2d& direction, double rate_radps);

// The stem of such a body now.
FallenTree StemOf(std::uint32_t asset, const Asset& tree, const BodyMotion& motion);

// What makes a stem go on falling toward `toward` (unit, map frame) as long as it stands nearly
// upright and what felled it still leans on it: the moment of its weight at a lean of 30 degrees,
// no more than makes it turn with 1 rad/s.
Eigen::Vector3d ToppleTorque(const BodySpec& spec, const BodyMotion& motion,
                             const Eigen::Vector2d& toward);

// The horizontal force that roots and torn fibres exert at the foot until the tree lies: they keep
// it near the place where it stood [N].
Eigen::Vector3d RootForce(const Asset& tree, const BodySpec& spec, const BodyMotion& motion);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_PROPS_TREE_BODY_H_
