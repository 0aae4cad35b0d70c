#ifndef LATTICEWORLD_ROS_SERVER_BUNDLE_NAME_H_
#define LATTICEWORLD_ROS_SERVER_BUNDLE_NAME_H_

#include <string_view>

#include "latticeworld/common/status.h"

namespace latticeworld {

// OK for a name that stays below the worlds directory: a letter or digit, then letters, digits,
// '_', '-' and '.', at most so many; else INVALID_ARGUMENT that quotes it.
Status CheckBundleName(std::string_view name, std::size_t most_characters = 128);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_SERVER_BUNDLE_NAME_H_
