#ifndef LATTICEWORLD_SIMULATION_FOOTPRINT_H_
#define LATTICEWORLD_SIMULATION_FOOTPRINT_H_

#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/scene/element.h"
#include "latticeworld/scene/scene_changes.h"

namespace latticeworld {

// Distances on the map, for keeping clear of things. 0 inside.

// From a point to an element of that kind and size at a place and heading [m].
double DistanceToElement(const Element& element, WorldPoint at, double yaw_rad, WorldPoint point);

// From a point to the line of a stem that lies or falls [m].
double DistanceToStem(const FallenTree& tree, WorldPoint point);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_FOOTPRINT_H_
