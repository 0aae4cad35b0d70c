#include "latticeworld_ros/conversion/octomap_conversion.h"

#include <grid_map_msgs/GridMap.h>
#include <gtest/gtest.h>
#include <octomap/OcTree.h>
#include <octomap_msgs/GetOctomap.h>
#include <ros/message_traits.h>
#include <ros/service_traits.h>

#include <sstream>
#include <string>

#include "mapping/octree/tree_data.h"

namespace latticeworld {
namespace {

octomap::OcTree SmallTree() {
  octomap::OcTree tree(0.5);
  for (int i = 0; i < 20; ++i) tree.updateNode(octomap::point3d(0.5f * i, 1.0f, -2.0f), true);
  tree.prune();
  return tree;
}

std::string DataOf(const octomap_msgs::Octomap& message) {
  return std::string(message.data.begin(), message.data.end());
}

TEST(OctomapConversionTest, FullMessageReadsBackAsTheSameTree) {
  const octomap::OcTree tree = SmallTree();
  const auto message = ToOctomap(FullData(tree), tree.getResolution(), false);
  EXPECT_FALSE(message.binary);
  EXPECT_EQ(message.id, tree.getTreeType());
  EXPECT_EQ(message.header.frame_id, "map");
  octomap::OcTree back(message.resolution);
  std::stringstream stream(DataOf(message));
  back.readData(stream);
  EXPECT_TRUE(tree == back);
}

TEST(OctomapConversionTest, BinaryMessageReadsBackWithTheSameOccupiedVoxels) {
  const octomap::OcTree tree = SmallTree();
  const auto message = ToOctomap(BinaryData(tree), tree.getResolution(), true);
  EXPECT_TRUE(message.binary);
  octomap::OcTree back(message.resolution);
  std::stringstream stream(DataOf(message));
  back.readBinaryData(stream);
  for (int i = 0; i < 20; ++i) {
    const auto* node = back.search(0.5 * i, 1.0, -2.0);
    ASSERT_NE(node, nullptr);
    EXPECT_TRUE(back.isNodeOccupied(node));
  }
  EXPECT_EQ(back.search(0.0, 3.0, 0.0), nullptr);
}

// What other programs are built against.
TEST(OctomapConversionTest, MessagesAreThoseThatTheWorldKnows) {
  EXPECT_STREQ(ros::message_traits::md5sum<octomap_msgs::Octomap>(),
               "9a45536b45c5e409cd49f04bb2d9999f");
  EXPECT_STREQ(ros::service_traits::md5sum<octomap_msgs::GetOctomap>(),
               "be9d2869d24fe40d6bc21ac21f6bb2c5");
  EXPECT_STREQ(ros::message_traits::md5sum<grid_map_msgs::GridMapInfo>(),
               "43ee5430e1c253682111cb6bedac0ef9");
  EXPECT_STREQ(ros::message_traits::md5sum<grid_map_msgs::GridMap>(),
               "95681e052b1f73bf87b7eb984382b401");
}

}  // namespace
}  // namespace latticeworld
