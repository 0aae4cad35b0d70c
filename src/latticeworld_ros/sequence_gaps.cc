#include "latticeworld_ros/sequence_gaps.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <sstream>
#include <vector>

namespace latticeworld {
namespace {

// Whether the first field of a message definition is a header; comments and constants may stand
// before it.
bool BeginsWithHeader(const std::string& definition) {
  std::istringstream lines(definition);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string type;
    if (!(words >> type) || line.find('=') != std::string::npos) continue;
    return type == "Header" || type == "std_msgs/Header";
  }
  return false;
}

std::optional<std::uint32_t> SequenceOf(const BagMessage& message) {
  if (message.bytes() < sizeof(std::uint32_t)) return std::nullopt;
  if (!BeginsWithHeader(message.message->getMessageDefinition())) return std::nullopt;
  std::vector<std::uint8_t> bytes(message.bytes());
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  message.message->write(stream);
  // ROS writes numbers with their least byte first.
  return std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
         std::uint32_t{bytes[3]} << 24;
}

std::string PublisherOf(const BagMessage& message) {
  if (message.header == nullptr) return "";
  const auto caller = message.header->find("callerid");
  return caller == message.header->end() ? "" : caller->second;
}

}  // namespace

std::uint64_t SequenceGaps::MissingBefore(const BagMessage& message) {
  const std::optional<std::uint32_t> sequence = SequenceOf(message);
  if (!sequence) return 0;
  const auto [known, is_first] =
      last_.emplace(std::pair(message.topic, PublisherOf(message)), *sequence);
  if (is_first) return 0;
  // A publisher that begins anew counts from below.
  const std::uint64_t missing =
      *sequence > known->second + 1 ? std::uint64_t{*sequence} - known->second - 1 : 0;
  known->second = *sequence;
  return missing;
}

}  // namespace latticeworld
