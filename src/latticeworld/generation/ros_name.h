#ifndef LATTICEWORLD_GENERATION_ROS_NAME_H_
#define LATTICEWORLD_GENERATION_ROS_NAME_H_

#include <algorithm>
#include <string_view>

namespace latticeworld {

// A graph resource name without slashes: a letter, then letters, digits and underscores.
inline bool IsRosName(std::string_view name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_legal = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && is_letter(name[0]) && std::all_of(name.begin(), name.end(), is_legal);
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_ROS_NAME_H_
