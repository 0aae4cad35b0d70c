#ifndef LATTICEWORLD_ROS_EPISODE_SEQUENCE_GAPS_H_
#define LATTICEWORLD_ROS_EPISODE_SEQUENCE_GAPS_H_

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "latticeworld_ros/episode/bag_file.h"
#include "latticeworld_ros/episode/bag_stamp.h"

namespace latticeworld {

// Counts messages that were lost on the way: roscpp numbers what a publisher publishes in each
// header, those too that find its queue full, and world_server its tf in the first transform (other
// broadcasters leave 0 there). Messages without a number cannot be counted.
class SequenceGaps {
 public:
  // How many messages of its topic and publisher are missing before this one. stamp: the message's.
  std::uint64_t MissingBefore(const BagMessage& message, const BagStamp& stamp);

 private:
  std::map<std::pair<std::string, std::string>, std::uint32_t> last_;  // topic and publisher
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_EPISODE_SEQUENCE_GAPS_H_
