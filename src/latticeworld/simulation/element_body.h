#ifndef LATTICEWORLD_SIMULATION_ELEMENT_BODY_H_
#define LATTICEWORLD_SIMULATION_ELEMENT_BODY_H_

#include "latticeworld/scene/element.h"
#include "latticeworld/simulation/physics_world.h"
#include "latticeworld/simulation/water_forces.h"

namespace latticeworld {

// A gate turns so far to either side [rad].
inline constexpr double kWidestOpening_rad = 1.5;

// The body of an element. base_link is the element's frame, but that of a gate, which is at the
// middle of its panel's base. A loose stone stands on the twelve corners of an icosahedron in its
// ball: it lies still on slopes of up to about 20 degrees and rolls on steeper ones.
BodySpec ElementBodyOf(const Element& element);
// The plank of a bridge that breaks out of it: what is left of it is the middle.
Element BrokenDeckOf(const Element& bridge);
Buoyancy ElementBuoyancyOf(const Element& element);
// Moment at the base over the angle by which a post leans [N m/rad].
double PostStiffness(const Element& post);

// Where base_link of the element's body is when it begins.
BodyMotion BeginningOf(const Element& element);
// map_from_element when its body is there.
BodyMotion ElementPoseOf(const Element& element, const BodyMotion& body);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ELEMENT_BODY_H_
