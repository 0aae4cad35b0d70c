#ifndef LATTICEWORLD_ROS_PUBLISHING_MAP_PUBLISHER_H_
#define LATTICEWORLD_ROS_PUBLISHING_MAP_PUBLISHER_H_

#include <ros/ros.h>

#include <memory>
#include <mutex>

#include "latticeworld_ros/publishing/world_messages.h"
#include "latticeworld_ros/server/current_world.h"

namespace latticeworld {

// The latched topics of a world: world/info, world/layout, world/environment, world/height_map,
// world/height_image, world/markers, octomap_full, octomap_binary, map. What is published is the
// current world.
class MapPublisher {
 public:
  // current: outlives the publisher, which alone sets it.
  MapPublisher(ros::NodeHandle node, CurrentWorld* current);

  // Makes `next` the current world and publishes what is another message than the last time: a late
  // subscriber gets the one message of each topic, and who listens hears of each change once. Takes
  // tens of milliseconds: not for the simulation loop's thread.
  void Publish(std::shared_ptr<const PublishedWorld> next);
  // The same, if `expected` is the current world still; false: it is not.
  bool PublishInPlaceOf(const PublishedWorld* expected, std::shared_ptr<const PublishedWorld> next);

 private:
  void PublishLocked(std::shared_ptr<const PublishedWorld> next);

  CurrentWorld* const current_;
  std::mutex mutex_;  // one world is published at a time
  ros::Publisher info_, layout_, environment_, height_map_, height_image_, markers_, octomap_full_,
      octomap_binary_, map_, scan_map_;
  WorldMessages published_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_PUBLISHING_MAP_PUBLISHER_H_
