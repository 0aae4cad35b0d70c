#ifndef LATTICEWORLD_GENERATION_BUNDLE_H_
#define LATTICEWORLD_GENERATION_BUNDLE_H_

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/generation/world.h"

namespace latticeworld {

// Writes the world's bundle (INTERFACES, "World bundle") as a new directory, whole or not at all.
// Errors: ALREADY_EXISTS, PERMISSION_DENIED, RESOURCE_EXHAUSTED (disk full), NOT_FOUND (no parent).
Status SaveBundle(const World& world, const std::filesystem::path& directory);

// Reads it back. Errors: NOT_FOUND; DATA_LOSS naming the damaged file and why (missing, checksum,
// content); FAILED_PRECONDITION for another format version.
Result<std::shared_ptr<const World>> LoadBundle(const std::filesystem::path& directory);

struct BundleSummary {
  std::string name;  // directory name
  std::string world_id;
  std::string layout_instruction;
};
// The bundles directly below a directory, sorted by name; what is no bundle is left out.
Result<std::vector<BundleSummary>> ListBundles(const std::filesystem::path& directory);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_BUNDLE_H_
