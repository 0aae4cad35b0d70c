#ifndef LATTICEWORLD_ROS_NODE_SERVICE_ADDRESS_H_
#define LATTICEWORLD_ROS_NODE_SERVICE_ADDRESS_H_

#include <string>

namespace latticeworld {

// Returns where the master says that a service can be called, HOST:PORT. The port is a process's
// own, so that a node that ended and started again has another one. Empty: nowhere, or there is no
// master.
std::string ServiceAddress(const std::string& service);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NODE_SERVICE_ADDRESS_H_
