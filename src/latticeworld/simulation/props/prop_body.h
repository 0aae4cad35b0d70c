#ifndef LATTICEWORLD_SIMULATION_PROPS_PROP_BODY_H_
#define LATTICEWORLD_SIMULATION_PROPS_PROP_BODY_H_

#include "latticeworld/scene/props/prop.h"
#include "latticeworld/simulation/physics_world.h"
#include "latticeworld/simulation/water_forces.h"

namespace latticeworld {

// A gate turns so far to either side [rad].
inline constexpr double kWidestOpening_rad = 1.5;

// The body of a prop. base_link is the prop's frame, but that of a gate, which is at the
// middle of its panel's base. A loose stone stands on the twelve corners of an icosahedron in its
// ball: it lies still on slopes of up to about 20 degrees and rolls on steeper ones.
BodySpec PropBodyOf(const Prop& prop);
// The plank of a bridge that breaks out of it: what is left of it is the middle.
Prop BrokenDeckOf(const Prop& bridge);
Buoyancy PropBuoyancyOf(const Prop& prop);
// Moment at the base over the angle by which a post leans [N m/rad].
double PostStiffness(const Prop& post);

// Returns where base_link of the prop's body is when it begins.
BodyMotion BeginningOf(const Prop& prop);
// map_from_prop when its body is there.
BodyMotion PropPoseOf(const Prop& prop, const BodyMotion& body);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_PROPS_PROP_BODY_H_
