#ifndef LATTICEWORLD_GENERATION_BUNDLE_MANIFEST_H_
#define LATTICEWORLD_GENERATION_BUNDLE_MANIFEST_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/generation/world.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/scene/weather/atmosphere.h"

namespace latticeworld {

inline constexpr int kBundleFormatVersion = 7;
inline constexpr int kOldestBundleFormatVersion = 5;  // that is read

// One file of a bundle besides the manifest itself.
struct BundleFile {
  std::string name;  // relative, with '/': "weights/F.png"
  std::uint64_t bytes = 0;
  std::string sha256;  // 64 hexadecimal digits
};

// What world.json says: all of a world that has no file of its own, and what its files are.
struct Manifest {
  std::string world_id;
  std::optional<GeoOrigin> geo;
  GenerationRequest request;  // without the picture's bytes, which are in the file "visual"
  double height_png_scale_m = 0.0;
  double height_png_offset_m = 0.0;
  double water_png_scale_m = 0.0;
  double octree_resolution_m = 0.0;
  MapValues map_values = MapValues::kGraded;  // of map.pgm
  Atmosphere atmosphere;
  std::vector<std::string> warnings;
  std::vector<StageTime> stages;
  std::vector<BundleFile> files;  // in the order in which they were written
};

// The JSON of a manifest. Its last value is the SHA-256 of the whole text with that value's digits
// written as zeros, so that a change anywhere in it is seen.
std::string EncodeManifest(const Manifest& manifest);

// Errors: DATA_LOSS saying what is wrong (no JSON, another digest than it carries, keys, types,
// values); FAILED_PRECONDITION naming both versions for another format version.
Result<Manifest> DecodeManifest(std::string_view content);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_BUNDLE_MANIFEST_H_
