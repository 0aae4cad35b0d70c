#ifndef LATTICEWORLD_EXPORTING_MAPS_MAP_SERVER_H_
#define LATTICEWORLD_EXPORTING_MAPS_MAP_SERVER_H_

#include <cstdint>
#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/mapping/traversability.h"

namespace latticeworld {

struct MapServerFiles {
  std::string pgm;   // content of map.pgm, binary, first row north
  std::string yaml;  // content of map.yaml, naming map.pgm
};
// Files from which ROS map_server publishes the same occupancy again. occupancy: 0..100, -1
// unknown, (rows x cols) of geometry. mode: scale, in which 99 reads back as 98; where cells are
// unknown mode: raw, for scale cannot say so in a PGM. Trinary values (of WithValues) get mode:
// trinary, with the greys and thresholds of map_saver. Errors: INVALID_ARGUMENT (another shape than
// the geometry's, a value that is none of these).
Result<MapServerFiles> ToMapServer(const Grid<std::int8_t>& occupancy, const GridGeometry& geometry,
                                   MapValues values = MapValues::kGraded);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_MAPS_MAP_SERVER_H_
