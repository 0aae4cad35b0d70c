#ifndef LATTICEWORLD_ROS_CONVERSION_AGENT_MARKERS_H_
#define LATTICEWORLD_ROS_CONVERSION_AGENT_MARKERS_H_

#include <ros/time.h>
#include <visualization_msgs/MarkerArray.h>

#include "latticeworld/scene/scene.h"
#include "latticeworld/simulation/world_state.h"
#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {

// What moves, for rviz, as it stands or lies: of every agent a body of its species' size, coloured
// by team (the dead are faint), an arrow along its x and its name; props; trees while they fall.
// Namespaces bodies, headings, names, props, trees. The first marker deletes what is gone.
visualization_msgs::MarkerArray ToMarkerArray(const WorldState& state, const Scene& scene,
                                              const SpeciesCatalogue& catalogue, ros::Time stamp);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_AGENT_MARKERS_H_
