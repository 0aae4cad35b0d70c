#include "latticeworld_ros/conversion/status_conversion.h"

namespace latticeworld {

latticeworld_msgs::Status ToStatusMessage(const Status& status) {
  latticeworld_msgs::Status message;
  message.code = static_cast<std::uint8_t>(status.code());
  message.message = status.message();
  return message;
}

}  // namespace latticeworld
