#ifndef LATTICEWORLD_GENERATION_BUNDLE_BUNDLE_FILES_H_
#define LATTICEWORLD_GENERATION_BUNDLE_BUNDLE_FILES_H_

#include <cstdint>
#include <filesystem>
#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/generation/bundle/manifest.h"

namespace latticeworld {

// Names of the files of a bundle.
inline constexpr char kManifestFile[] = "world.json";
inline constexpr char kLayoutFile[] = "layout.txt";
inline constexpr char kEnvironmentFile[] = "environment.json";
inline constexpr char kFidelityFile[] = "fidelity.json";
inline constexpr char kRepliesFile[] = "replies.json";
inline constexpr char kCatalogueFile[] = "catalogue.json";
inline constexpr char kTerrainFile[] = "terrain.bin";
inline constexpr char kAssetsFile[] = "assets.csv";
inline constexpr char kAgentsFile[] = "agents.json";
inline constexpr char kPropsFile[] = "elements.json";
inline constexpr char kBridgesFile[] = "bridges.json";
inline constexpr char kThingsFile[] = "things.json";
inline constexpr char kVisualFile[] = "visual";
inline constexpr char kHeightFile[] = "height.png";
inline constexpr char kWaterFile[] = "water.png";
inline constexpr char kMapPictureFile[] = "map.pgm";
inline constexpr char kMapFile[] = "map.yaml";
inline constexpr char kOctreeFile[] = "world.bt";
inline constexpr char kPreviewFile[] = "preview.png";
inline std::string WeightFile(char letter) { return std::string("weights/") + letter + ".png"; }

// Limits of what is read into memory; a world of the largest size stays below them. A manifest
// takes some 40 times its bytes while it is read; instructions of the greatest length that are
// hardly understood make one of some 70 kB.
inline constexpr std::size_t kMaxManifestBytes = 1u << 20;
inline constexpr std::size_t kMaxBundleFileBytes = 2048u << 20;

// The manifest of the bundle in a directory. Errors: as LoadBundle.
Result<Manifest> ReadManifest(const std::filesystem::path& directory);
// The manifest of the bundle that SaveBundle would make of a world; nothing is written.
// Errors: RESOURCE_EXHAUSTED.
Result<Manifest> MakeManifest(const World& world, MapValues map_values = MapValues::kGraded);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_BUNDLE_BUNDLE_FILES_H_
