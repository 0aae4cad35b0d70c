#ifndef LATTICEWORLD_GENERATION_BUNDLE_BUNDLE_H_
#define LATTICEWORLD_GENERATION_BUNDLE_BUNDLE_H_

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/generation/world.h"
#include "latticeworld/mapping/traversability.h"

namespace latticeworld {

// A world on disk: one directory with a manifest (world.json), what a world is read back from, and
// the same in the formats of other programs. LoadBundle(SaveBundle(world)) is the same world: same
// id, same bits in every grid, whatever back ends this program has and however it would decode the
// layout today.
//
// read back   layout.txt, environment.json, fidelity.json (claims of the words, measured),
//             replies.json (what a language model answered), assets.csv, agents.json,
//             props.json, terrain.bin (every grid of the terrain, see terrain_file.h); where
//             there are any, bridges.json (of roads), things.json (single things), visual (the
//             request's picture) and catalogue.json (what a user added to the catalogue)
// others'     height.png, water.png (16 bit), weights/<letter>.png (8 bit), map.pgm and map.yaml
//             (map_server), world.bt (OctoMap), preview.png; loading checks their digests only
//
// world.json lists every file with its length and SHA-256 and carries its own.

// Writes the bundle as a new directory, whole or not at all. map_values: of map.pgm.
// Errors: ALREADY_EXISTS, PERMISSION_DENIED, RESOURCE_EXHAUSTED (disk full), NOT_FOUND (no parent).
Status SaveBundle(const World& world, const std::filesystem::path& directory,
                  MapValues map_values = MapValues::kGraded);

// Reads it back. Trusts nothing: lengths, digests and then every value are checked. Errors:
// NOT_FOUND (no such directory); DATA_LOSS naming the damaged file and why (missing, length,
// digest, content); FAILED_PRECONDITION for another format version.
Result<std::shared_ptr<const World>> LoadBundle(const std::filesystem::path& directory);

struct BundleSummary {
  std::string name;  // directory name
  std::string world_id;
  std::string layout_instruction;
};
// The bundles directly below a directory, sorted by name; what is no bundle is left out. Only the
// manifests are read. Errors: NOT_FOUND, PERMISSION_DENIED.
Result<std::vector<BundleSummary>> ListBundles(const std::filesystem::path& directory);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_BUNDLE_BUNDLE_H_
