#include "latticeworld_ros/publishing/map_publisher.h"

#include <utility>

namespace latticeworld {
namespace {

template <typename Message>
ros::Publisher Latched(ros::NodeHandle* node, const char* topic) {
  return node->advertise<Message>(topic, 1, /*latch=*/true);
}

// Messages never change once they are published, so that another one is another object.
template <typename Message>
void PublishNew(const ros::Publisher& topic, const boost::shared_ptr<Message>& message,
                boost::shared_ptr<Message>* published) {
  if (message == *published) return;
  topic.publish(message);
  *published = message;
}

}  // namespace

MapPublisher::MapPublisher(ros::NodeHandle node, CurrentWorld* current)
    : current_(current),
      info_(Latched<latticeworld_msgs::WorldInfo>(&node, "world/info")),
      layout_(Latched<latticeworld_msgs::Layout>(&node, "world/layout")),
      environment_(Latched<latticeworld_msgs::Environment>(&node, "world/environment")),
      height_map_(Latched<grid_map_msgs::GridMap>(&node, "world/height_map")),
      height_image_(Latched<sensor_msgs::Image>(&node, "world/height_image")),
      markers_(Latched<visualization_msgs::MarkerArray>(&node, "world/markers")),
      octomap_full_(Latched<octomap_msgs::Octomap>(&node, "octomap_full")),
      octomap_binary_(Latched<octomap_msgs::Octomap>(&node, "octomap_binary")),
      map_(Latched<nav_msgs::OccupancyGrid>(&node, "map")),
      scan_map_(Latched<nav_msgs::OccupancyGrid>(&node, "world/scan_map")) {}

void MapPublisher::Publish(std::shared_ptr<const PublishedWorld> next) {
  const std::lock_guard<std::mutex> lock(mutex_);
  PublishLocked(std::move(next));
}

bool MapPublisher::PublishInPlaceOf(const PublishedWorld* expected,
                                    std::shared_ptr<const PublishedWorld> next) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (current_->Get().get() != expected) return false;
  PublishLocked(std::move(next));
  return true;
}

void MapPublisher::PublishLocked(std::shared_ptr<const PublishedWorld> next) {
  const WorldMessages& messages = next->messages;
  current_->Set(next);
  PublishNew(info_, messages.info, &published_.info);
  PublishNew(layout_, messages.layout, &published_.layout);
  PublishNew(environment_, messages.environment, &published_.environment);
  PublishNew(map_, messages.map, &published_.map);
  PublishNew(scan_map_, messages.scan_map, &published_.scan_map);
  PublishNew(octomap_binary_, messages.octomap_binary, &published_.octomap_binary);
  PublishNew(octomap_full_, messages.octomap_full, &published_.octomap_full);
  PublishNew(height_map_, messages.height_map, &published_.height_map);
  PublishNew(height_image_, messages.height_image, &published_.height_image);
  PublishNew(markers_, messages.markers, &published_.markers);
}

}  // namespace latticeworld
