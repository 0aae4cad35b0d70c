#ifndef LATTICEWORLD_ROS_EPISODE_BAG_STAMP_H_
#define LATTICEWORLD_ROS_EPISODE_BAG_STAMP_H_

#include <ros/time.h>

#include <cstdint>
#include <optional>

#include "latticeworld_ros/episode/bag_file.h"

namespace latticeworld {

// What a message of any type says of itself in its first bytes.
struct BagStamp {
  // Which of its publisher's messages it is; nullopt: it does not say.
  std::optional<std::uint32_t> sequence;
  std::optional<ros::Time> stamp;  // when what it tells was; nullopt: it does not say
};

// Returns, of a message that begins with a std_msgs/Header, its number, which roscpp gives, and its
// stamp; of tf those of the first transform, where world_server numbers its messages from 1 on and
// others leave 0, which is no number; of the clock its time alone. A stamp of 0 says nothing.
BagStamp StampOf(const BagMessage& message);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_EPISODE_BAG_STAMP_H_
