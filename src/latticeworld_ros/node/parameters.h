#ifndef LATTICEWORLD_ROS_NODE_PARAMETERS_H_
#define LATTICEWORLD_ROS_NODE_PARAMETERS_H_

#include <XmlRpcValue.h>

#include <filesystem>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld_ros/server/world_server_options.h"

namespace latticeworld {

// The options that a node's private parameters say: a struct of name to value, or an invalid value
// for none at all. Absent ones keep their defaults. Reads the files that `species` names. Errors:
// INVALID_ARGUMENT naming every unknown name, every wrong type, every value out of range and what
// is wrong with those files.
Result<WorldServerOptions> OptionsFromParameters(const XmlRpc::XmlRpcValue& parameters);

// "~" and "~/..." below the home directory, where there is one; "~/.ros" is $ROS_HOME where that is
// set, as it is for ROS itself.
std::filesystem::path ExpandHome(const std::string& path);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NODE_PARAMETERS_H_
