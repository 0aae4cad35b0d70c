#ifndef LATTICEWORLD_ROS_MAP_PUBLISHER_H_
#define LATTICEWORLD_ROS_MAP_PUBLISHER_H_

#include <ros/ros.h>

#include "latticeworld_ros/world_messages.h"

namespace latticeworld {

// The latched topics of a world: world/info, world/layout, world/environment, world/height_map,
// world/height_image, world/markers, octomap_full, octomap_binary, map.
class MapPublisher {
 public:
  explicit MapPublisher(ros::NodeHandle node);

  // Publishes what is another message than the last time: a late subscriber gets the one message of
  // each topic, and who listens hears of each change once. Takes tens of milliseconds: not for the
  // simulation loop's thread. From one thread at a time.
  void Publish(const WorldMessages& messages);

 private:
  ros::Publisher info_, layout_, environment_, height_map_, height_image_, markers_, octomap_full_,
      octomap_binary_, map_;
  WorldMessages published_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_MAP_PUBLISHER_H_
