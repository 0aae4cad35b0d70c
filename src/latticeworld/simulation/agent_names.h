#ifndef LATTICEWORLD_SIMULATION_AGENT_NAMES_H_
#define LATTICEWORLD_SIMULATION_AGENT_NAMES_H_

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/status.h"

namespace latticeworld {

// A violation of the field "name" unless that is a legal ROS base name (a letter, then letters,
// digits and underscores) of at most 64 characters. For agents and props.
void CheckAgentName(std::string_view name, std::vector<Violation>* violations);

// "wheeled_robot_3" of "wheeled robot" and 3
std::string NumberedName(std::string_view kind, int number);

// NOT_FOUND that says so of that kind ("agent") and names those that there are, the first few of
// them.
Status NoneNamed(std::string_view kind, std::string_view name,
                 const std::vector<std::string>& names);
template <typename Value>
Status NoneNamed(std::string_view kind, std::string_view name,
                 const std::map<std::string, Value>& by_name) {
  std::vector<std::string> names;
  for (const auto& [one, value] : by_name) names.push_back(one);
  return NoneNamed(kind, name, names);
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENT_NAMES_H_
