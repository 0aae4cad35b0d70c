#include "latticeworld_ros/octomap_conversion.h"

#include <octomap/OcTree.h>

#include <string>

#include "latticeworld/mapping/octree.h"
#include "latticeworld_ros/agent_conversion.h"

namespace latticeworld {

octomap_msgs::Octomap ToRos(const octomap::OcTree& tree, bool binary) {
  octomap_msgs::Octomap message;
  message.header.frame_id = kMapFrame;
  message.binary = binary;
  message.id = tree.getTreeType();
  message.resolution = tree.getResolution();
  const std::string data = binary ? BinaryData(tree) : FullData(tree);
  message.data.assign(data.begin(), data.end());
  return message;
}

}  // namespace latticeworld
