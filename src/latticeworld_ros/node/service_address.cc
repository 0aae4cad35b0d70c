#include "latticeworld_ros/node/service_address.h"

#include <ros/names.h>
#include <ros/service_manager.h>

#include <cstdint>

namespace latticeworld {

std::string ServiceAddress(const std::string& service) {
  std::string host;
  std::uint32_t port = 0;
  const bool found =
      ros::ServiceManager::instance()->lookupService(ros::names::resolve(service), host, port);
  return found ? host + ":" + std::to_string(port) : std::string();
}

}  // namespace latticeworld
