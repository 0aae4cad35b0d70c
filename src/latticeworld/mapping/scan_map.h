#ifndef LATTICEWORLD_MAPPING_SCAN_MAP_H_
#define LATTICEWORLD_MAPPING_SCAN_MAP_H_

#include <cstdint>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/scene/scene_changes.h"

namespace latticeworld {

struct Scene;

// How high above the ground the scanner of the built-in wheeled robot looks [m].
inline constexpr double kScanHeight_m = 0.45;

// What a level scan at that height above the ground can meet: (rows x cols) of the scene's
// geometry, row 0 north, 100 where something stands that reaches so high, else 0. That is another
// map than that of where a robot can go: crops, bushes and tall grass are on it, water, steep
// ground and low stones are not, and nothing is grown by a robot's radius. Props and trees that
// lie are on it however low they are. Ground that rises into the scan is not on it either, for that
// depends on where the scanner is. scan_height_m: finite, above 0. changes and threads: as
// BuildOccupancy.
Grid<std::int8_t> BuildScanMap(const Scene& scene, double scan_height_m = kScanHeight_m,
                               const SceneChanges& changes = {}, int threads = 0);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_SCAN_MAP_H_
