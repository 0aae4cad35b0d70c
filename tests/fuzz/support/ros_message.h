#ifndef LATTICEWORLD_TESTS_FUZZ_SUPPORT_ROS_MESSAGE_H_
#define LATTICEWORLD_TESTS_FUZZ_SUPPORT_ROS_MESSAGE_H_

#include <ros/serialization.h>

#include <exception>
#include <string_view>
#include <vector>

#include "fuzz/fuzz_target.h"
#include "fuzz/support/allocation_limit.h"

namespace latticeworld::fuzz {

// Reads a serialized message as roscpp does, and hands it to `use`. What roscpp refuses (it is cut
// short, or its lengths lie) is not handed on.
template <typename Message, typename Use>
void WithMessage(std::string_view bytes, const Use& use) {
  constexpr std::size_t kMostAllocated = std::size_t{1} << 20;
  std::vector<std::uint8_t> buffer(bytes.begin(), bytes.end());
  Message message;
  try {
    const AllocationLimit limit(kMostAllocated);
    ros::serialization::IStream stream(buffer.data(), static_cast<std::uint32_t>(buffer.size()));
    ros::serialization::deserialize(stream, message);
  } catch (const std::exception&) {  // ros::serialization::StreamOverrunException, std::bad_alloc
    return;
  }
  use(message);
}

}  // namespace latticeworld::fuzz

#endif  // LATTICEWORLD_TESTS_FUZZ_SUPPORT_ROS_MESSAGE_H_
