#ifndef LATTICEWORLD_COMMON_DATA_FILES_H_
#define LATTICEWORLD_COMMON_DATA_FILES_H_

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"

namespace latticeworld {

// This header finds files that add to what is built in: species, sensors, what worlds are furnished
// with.

// The *.json of a folder, sorted, or the file itself, whether or not there is one. Errors:
// NOT_FOUND (a folder without any), PERMISSION_DENIED (one that cannot be listed), INVALID_ARGUMENT
// (more than `most`).
Result<std::vector<std::filesystem::path>> JsonFilesAt(const std::filesystem::path& path,
                                                       std::size_t most);

// Whether no violation speaks of the value at the JSON pointer or of a part of it.
bool IsSound(const std::string& pointer, const std::vector<Violation>& violations);

}  // namespace latticeworld

#endif  // LATTICEWORLD_COMMON_DATA_FILES_H_
