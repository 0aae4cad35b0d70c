#ifndef LATTICEWORLD_ROS_OCTOMAP_CONVERSION_H_
#define LATTICEWORLD_ROS_OCTOMAP_CONVERSION_H_

#include <octomap_msgs/Octomap.h>

namespace octomap {
class OcTree;
}

namespace latticeworld {

// Frame map, stamp left at zero. binary: occupied or not; else every node's value.
octomap_msgs::Octomap ToRos(const octomap::OcTree& tree, bool binary);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_OCTOMAP_CONVERSION_H_
