#ifndef LATTICEWORLD_ROS_AGENT_MARKERS_H_
#define LATTICEWORLD_ROS_AGENT_MARKERS_H_

#include <ros/time.h>
#include <visualization_msgs/MarkerArray.h>

#include "latticeworld/simulation/world_state.h"

namespace latticeworld {

// An arrow-headed body and a name a living agent, coloured by team, for rviz. The first marker
// deletes those of agents that are gone.
visualization_msgs::MarkerArray ToMarkers(const WorldState& state, ros::Time stamp);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_AGENT_MARKERS_H_
