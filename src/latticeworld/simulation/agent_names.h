#ifndef LATTICEWORLD_SIMULATION_AGENT_NAMES_H_
#define LATTICEWORLD_SIMULATION_AGENT_NAMES_H_

#include <string>
#include <string_view>

#include "latticeworld/common/status.h"
#include "latticeworld/environment/agent_group.h"

namespace latticeworld {

// OK for a legal ROS base name (a letter, then letters, digits and underscores) of at most 64
// characters; else INVALID_ARGUMENT that quotes it.
Status CheckAgentName(std::string_view name);

// "wheeled_robot_3"
std::string NumberedName(AgentCategory category, int number);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENT_NAMES_H_
