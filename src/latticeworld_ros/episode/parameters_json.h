#ifndef LATTICEWORLD_ROS_EPISODE_PARAMETERS_JSON_H_
#define LATTICEWORLD_ROS_EPISODE_PARAMETERS_JSON_H_

#include <XmlRpcValue.h>

#include <string>

namespace latticeworld {

// ROS parameters as JSON: structs as objects, lists as arrays; times and binary data as texts.
std::string ParametersToJson(const XmlRpc::XmlRpcValue& parameters);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_EPISODE_PARAMETERS_JSON_H_
