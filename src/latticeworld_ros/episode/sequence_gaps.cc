#include "latticeworld_ros/episode/sequence_gaps.h"

namespace latticeworld {
namespace {

std::string PublisherOf(const BagMessage& message) {
  if (message.header == nullptr) return "";
  const auto caller = message.header->find("callerid");
  return caller == message.header->end() ? "" : caller->second;
}

}  // namespace

std::uint64_t SequenceGaps::MissingBefore(const BagMessage& message, const BagStamp& stamp) {
  if (!stamp.sequence) return 0;
  const std::uint32_t sequence = *stamp.sequence;
  const auto [known, is_first] =
      last_.emplace(std::pair(message.topic, PublisherOf(message)), sequence);
  if (is_first) return 0;
  // A publisher that begins anew counts from below.
  const std::uint64_t missing =
      sequence > known->second + 1 ? std::uint64_t{sequence} - known->second - 1 : 0;
  known->second = sequence;
  return missing;
}

}  // namespace latticeworld
