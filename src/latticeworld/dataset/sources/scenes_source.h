#ifndef LATTICEWORLD_DATASET_SOURCES_SCENES_SOURCE_H_
#define LATTICEWORLD_DATASET_SOURCES_SCENES_SOURCE_H_

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/dataset/sources/instance_source.h"

namespace latticeworld {

inline constexpr int kTileSize = 512;  // pixels a side

struct ScenesOptions {
  std::filesystem::path folder;
  // [0, 0.5]: how far rivers cut back into the land, as a share of the scene's shorter side; 0
  // leaves it as measured.
  double erosion = 0.05;
};
std::vector<Violation> Validate(const ScenesOptions& options);

// What of a picture lies in whole tiles, counted from the upper left corner.
struct TileCount {
  int rows = 0, cols = 0;    // of tiles
  std::int64_t dropped = 0;  // pixels at the right and lower edge that fill no tile
};
TileCount TilesOf(std::int64_t width, std::int64_t height);

// Places from segmented pictures with elevation:
//
//   classes.json                       optional: what pixels mean (ReadLegend); without it they
//                                      have the colours of wild layouts (PaletteLegend)
//   scenes/<name>/segmentation.png     at least 512 pixels a side
//   scenes/<name>/elevation.tif        a sample a pixel, in metres: GeoTIFF with a projected
//                                      coordinate system and square samples
//
// A group is a scene, its instances are all tiles of 512 x 512 pixels that fit ("<group>-y0-x0");
// what is left at the edges is dropped, and counted in the card's title. The land of the whole
// scene is eroded by stream power for as long as its largest rivers need to cut back by
// options.erosion, then cut into tiles, each with its lowest place at 0. Tiles of which more than
// half is no data are left out.
//
// Errors: NOT_FOUND (no folder), INVALID_ARGUMENT (options; a folder without scenes; a classes.json
// that is not legal), PERMISSION_DENIED. A group's errors are those of InstanceSource; samples that
// are not square; more than half of the elevation missing; no tile that fits.
Result<std::unique_ptr<InstanceSource>> MakeScenesSource(const ScenesOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_SOURCES_SCENES_SOURCE_H_
