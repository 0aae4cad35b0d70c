#ifndef LATTICEWORLD_ROS_NAVIGATOR_NAVIGATOR_OUTPUT_H_
#define LATTICEWORLD_ROS_NAVIGATOR_NAVIGATOR_OUTPUT_H_

#include <geometry_msgs/Pose.h>
#include <nav_msgs/Path.h>
#include <std_msgs/Header.h>

#include <vector>

#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

// Upright at a place, looking that way.
geometry_msgs::Pose UprightPose(WorldPoint place, double z_m, double heading_rad);

// Each pose looks to the next one, the last as the one before it.
nav_msgs::Path ToPath(const std::vector<WorldPoint>& way, double z_m,
                      const std_msgs::Header& header);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NAVIGATOR_NAVIGATOR_OUTPUT_H_
