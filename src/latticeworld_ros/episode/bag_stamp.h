#ifndef LATTICEWORLD_ROS_EPISODE_BAG_STAMP_H_
#define LATTICEWORLD_ROS_EPISODE_BAG_STAMP_H_

#include <ros/time.h>

#include <cstdint>
#include <optional>

#include "latticeworld_ros/episode/bag_file.h"

namespace latticeworld {

// What a message of any type says of itself in its first bytes.
struct BagStamp {
  std::optional<std::uint32_t>
      sequence;                    // which of its publisher's messages it is; nullopt: no number
  std::optional<ros::Time> stamp;  // when what it tells was; nullopt: it does not say
};

// Returns, of a message that begins with a std_msgs/Header, its number and stamp; of tf those of
// the first transform; of the clock its time. A stamp of 0 says nothing, nor does a number of 0 in
// tf.
BagStamp StampOf(const BagMessage& message);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_EPISODE_BAG_STAMP_H_
