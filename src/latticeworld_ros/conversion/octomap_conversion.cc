#include "latticeworld_ros/conversion/octomap_conversion.h"

#include <utility>

#include "latticeworld_ros/conversion/geometry_conversion.h"

namespace latticeworld {

octomap_msgs::Octomap ToOctomap(OctreeData data, double resolution_m, bool binary) {
  octomap_msgs::Octomap message;
  message.header.frame_id = kMapFrame;
  message.binary = binary;
  message.id = "OcTree";  // octomap::OcTree::getTreeType()
  message.resolution = resolution_m;
  message.data = std::move(data.bytes);
  return message;
}

}  // namespace latticeworld
