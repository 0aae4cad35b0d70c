#ifndef LATTICEWORLD_TESTS_COMMON_SYNCED_DIRECTORIES_H_
#define LATTICEWORLD_TESTS_COMMON_SYNCED_DIRECTORIES_H_

#include <filesystem>
#include <vector>

namespace latticeworld {

// The directories that this program has synced so far, in order: linked with this, a test sees
// every call of fsync. A file keeps its name through a loss of power once its directory is among
// them.
std::vector<std::filesystem::path> SyncedDirectories();

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_COMMON_SYNCED_DIRECTORIES_H_
