#ifndef LATTICEWORLD_ROS_NODE_MESSAGE_SIZE_H_
#define LATTICEWORLD_ROS_NODE_MESSAGE_SIZE_H_

#include <cstdint>

namespace latticeworld {

// A message or an answer of more bytes is not received: roscpp takes it for a broken connection and
// hangs up, without a word to whoever sent it.
inline constexpr std::uint64_t kMostMessageBytes = 1'000'000'000;

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NODE_MESSAGE_SIZE_H_
