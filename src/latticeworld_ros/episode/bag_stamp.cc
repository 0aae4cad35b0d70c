#include "latticeworld_ros/episode/bag_stamp.h"

#include <cstddef>
#include <sstream>
#include <string>
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

// Bytes of a message as ROS writes it.
class FirstBytes {
 public:
  explicit FirstBytes(const BagMessage& message) : bytes_(message.bytes()) {
    ros::serialization::OStream stream(bytes_.data(), static_cast<std::uint32_t>(bytes_.size()));
    message.message->write(stream);
  }
  // Numbers are written with their least byte first.
  std::optional<std::uint32_t> NumberAt(std::size_t at) const {
    if (at + sizeof(std::uint32_t) > bytes_.size()) return std::nullopt;
    return std::uint32_t{bytes_[at]} | std::uint32_t{bytes_[at + 1]} << 8 |
           std::uint32_t{bytes_[at + 2]} << 16 | std::uint32_t{bytes_[at + 3]} << 24;
  }
  std::optional<ros::Time> TimeAt(std::size_t at) const {
    const auto seconds = NumberAt(at), nanoseconds = NumberAt(at + 4);
    constexpr std::uint32_t kSecond_ns = 1000000000;
    if (!seconds || !nanoseconds || *nanoseconds >= kSecond_ns) return std::nullopt;
    const ros::Time time(*seconds, *nanoseconds);
    return time.isZero() ? std::nullopt : std::optional(time);
  }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace

BagStamp StampOf(const BagMessage& message) {
  constexpr std::size_t kNumber = 4;  // bytes of a header's number, and of an array's length
  const std::string type = message.message->getDataType();
  const bool header = BeginsWithHeader(message.message->getMessageDefinition());
  const bool transforms = type == "tf2_msgs/TFMessage" || type == "tf/tfMessage";
  if (!header && !transforms && type != "rosgraph_msgs/Clock") return {};
  const FirstBytes bytes(message);
  if (header) return {bytes.NumberAt(0), bytes.TimeAt(kNumber)};
  if (!transforms) return {std::nullopt, bytes.TimeAt(0)};
  if (bytes.NumberAt(0).value_or(0) == 0) return {};
  const std::optional<std::uint32_t> number = bytes.NumberAt(kNumber);
  return {number == 0u ? std::nullopt : number, bytes.TimeAt(2 * kNumber)};
}

}  // namespace latticeworld
