#include "latticeworld_ros/map_publisher.h"

namespace latticeworld {
namespace {

template <typename Message>
ros::Publisher Latched(ros::NodeHandle* node, const char* topic) {
  return node->advertise<Message>(topic, 1, /*latch=*/true);
}

}  // namespace

MapPublisher::MapPublisher(ros::NodeHandle node)
    : info_(Latched<latticeworld_msgs::WorldInfo>(&node, "world/info")),
      layout_(Latched<latticeworld_msgs::Layout>(&node, "world/layout")),
      environment_(Latched<latticeworld_msgs::Environment>(&node, "world/environment")),
      height_map_(Latched<grid_map_msgs::GridMap>(&node, "world/height_map")),
      height_image_(Latched<sensor_msgs::Image>(&node, "world/height_image")),
      markers_(Latched<visualization_msgs::MarkerArray>(&node, "world/markers")),
      octomap_full_(Latched<octomap_msgs::Octomap>(&node, "octomap_full")),
      octomap_binary_(Latched<octomap_msgs::Octomap>(&node, "octomap_binary")),
      map_(Latched<nav_msgs::OccupancyGrid>(&node, "map")) {}

void MapPublisher::Publish(const WorldMessages& messages) {
  info_.publish(messages.info);
  layout_.publish(messages.layout);
  environment_.publish(messages.environment);
  map_.publish(messages.map);
  octomap_binary_.publish(messages.octomap_binary);
  octomap_full_.publish(messages.octomap_full);
  height_map_.publish(messages.height_map);
  height_image_.publish(messages.height_image);
  markers_.publish(messages.markers);
}

}  // namespace latticeworld
