#ifndef LATTICEWORLD_EXPORTING_SIMULATORS_MJCF_WORLD_H_
#define LATTICEWORLD_EXPORTING_SIMULATORS_MJCF_WORLD_H_

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/exporting/export_files.h"
#include "latticeworld/exporting/export_region.h"
#include "latticeworld/geometry/geo_origin.h"

namespace latticeworld {

struct Scene;

struct MjcfOptions {
  std::optional<ExportRegion> region;  // absent: the whole world
  int texture_px = 2048;               // of the ground's colours, [16, 8192]
  int detail = 2;                      // of the meshes, [0, 2], 0 the finest
  bool small_plants = false;           // grass, reed, flowers, crops
};
// Errors: INVALID_ARGUMENT with every violation.
Status Validate(const MjcfOptions& options, const Scene& scene);

inline constexpr std::size_t kMostMjcfThings = 50000;

// Meshes of things that are not boxes come in steps of a tenth of their size, so that things share
// them: what is seen is within 5 % of the thing; what collides is exact.
inline constexpr double kMjcfSizeStep = 1.1;

// A world as it begins for MuJoCo, as the files of a folder:
//
//   world.xml      MJCF: sun and sky; ground (height field), water (a mesh without collision),
//                  things, props; sites where agents begin
//   ground.hfield  MuJoCo's own format: rows and columns (int32), heights (float32, row by row, 0
//                  the lowest, 1 the highest), every cell of the region
//   ground.png, meshes/*.obj, looks/*.png
//
// MuJoCo splits the quads of a height field the other way than HeightField does, so the height
// field lies turned by a quarter: its rows go from east to west, its columns from south to north.
// So the two surfaces are the same. It ends at the centres of the outermost cells.
//
// Names: geoms "ground", "water", "asset_<number>" (seen, group 2) and "asset_<number>_solid" (what
// collides, as in the simulation here: trunks and stones as cylinders, buildings as boxes; group
// 3), props by their names (group 1; crates and loose stones are bodies with free joints), sites
// "start_<agent>". Things are geoms of the world and no bodies: MuJoCo (3.3, 4.0) has no memory for
// thousands of these. The ground's friction, which wins over that of what touches it, is the mean
// over the region's cells in the weather that the world begins in. Numerics of <custom>:
// "map_origin" (where the origin lies in the frame map [m]: the region's middle; 0 0 0 for the
// whole world), "geo" (latitude, longitude [deg], altitude [m] of the origin, where the world lies
// on the earth), "friction_<class>" of every class of ground that there is.
//
// Reports the stage "mjcf". Errors: INVALID_ARGUMENT (options; more than kMostMjcfThings),
// CANCELLED, INTERNAL.
Result<std::vector<ExportFile>> MjcfFiles(const Scene& scene, const std::string& name,
                                          const std::optional<GeoOrigin>& origin,
                                          const MjcfOptions& options, const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_SIMULATORS_MJCF_WORLD_H_
