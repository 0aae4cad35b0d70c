#ifndef LATTICEWORLD_ROS_CONVERSION_OCTOMAP_CONVERSION_H_
#define LATTICEWORLD_ROS_CONVERSION_OCTOMAP_CONVERSION_H_

#include <octomap_msgs/Octomap.h>

#include "latticeworld/mapping/octree/octree.h"

namespace latticeworld {

// Frame map, stamp left at zero. binary: data is octomap's binary stream, which knows occupied or
// not; else the full one, with every node's value.
octomap_msgs::Octomap ToOctomap(OctreeData data, double resolution_m, bool binary);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_OCTOMAP_CONVERSION_H_
