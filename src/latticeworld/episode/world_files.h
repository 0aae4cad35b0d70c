#ifndef LATTICEWORLD_EPISODE_WORLD_FILES_H_
#define LATTICEWORLD_EPISODE_WORLD_FILES_H_

#include <memory>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/generation/world.h"

namespace latticeworld {

// A file of a world's bundle, in memory.
struct WorldFile {
  std::string path;  // below the bundle, parts joined by '/'
  std::string data;
};

// The bundle of a world, as SaveBundle writes it; sorted by path. Goes by way of the system's
// directory for temporary files. Errors: as SaveBundle.
Result<std::vector<WorldFile>> PackWorld(const World& world);
// The world of such files. Trusts nothing, as LoadBundle, and writes nowhere but into a directory
// of its own. Errors: as LoadBundle; DATA_LOSS for a path that no bundle has.
Result<std::shared_ptr<const World>> UnpackWorld(const std::vector<WorldFile>& files);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EPISODE_WORLD_FILES_H_
