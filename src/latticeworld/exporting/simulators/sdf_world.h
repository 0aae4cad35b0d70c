#ifndef LATTICEWORLD_EXPORTING_SIMULATORS_SDF_WORLD_H_
#define LATTICEWORLD_EXPORTING_SIMULATORS_SDF_WORLD_H_

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

struct SdfOptions {
  std::optional<ExportRegion> region;  // square; absent: the whole world
  int heightmap_vertices = 0;  // a side: 2^n + 1, [17, 4097]; 0: as fine as the world's cells
                               // or finer, at most 2049
  int heightmap_bits = 16;     // 8 for readers that know no others (Gazebo classic): the
                               // steps of heights are then 1/255 of their range
  int texture_px = 2048;       // of the ground's colours, [16, 8192]
  int detail = 2;              // of the meshes, [0, 2], 0 the finest
  bool small_plants = false;   // grass, reed, flowers, crops
};
// Errors: INVALID_ARGUMENT with every violation.
Status Validate(const SdfOptions& options, const Scene& scene);

inline constexpr std::size_t kMostSdfThings = 50000;

// A world as it begins for Gazebo, SDF 1.7, as the files of a folder:
//
//   world.sdf                           physics, sun, scene; spherical coordinates where the world
//                                       lies on the earth; the models ground (height map), water
//                                       (a mesh without collision), one static model for the things
//                                       of each mesh and look, and one for each prop
//   latticeworld_media/model.config     what makes the folder one that model:// URIs find, and
//   latticeworld_media/model.sdf        the ground alone as its model
//   latticeworld_media/heightmap.png    (2^n + 1) a side, grey, the lowest ground 0
//   latticeworld_media/ground.jpg, flat.png, meshes/*.obj, meshes/*.mtl
//
// Readers find the media when the folder is on their path of models (GZ_SIM_RESOURCE_PATH, for
// Gazebo classic GAZEBO_MODEL_PATH). Bodies collide as in the simulation here: trunks and stones as
// cylinders, buildings as boxes. Crates and loose stones can be moved; agents are not part of it.
// Where the region is not the whole world, its middle becomes the origin. Reports the stage "sdf".
// Errors: INVALID_ARGUMENT (options; more than kMostSdfThings), CANCELLED, INTERNAL.
Result<std::vector<ExportFile>> SdfFiles(const Scene& scene, const std::string& name,
                                         const std::optional<GeoOrigin>& origin,
                                         const SdfOptions& options, const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_SIMULATORS_SDF_WORLD_H_
