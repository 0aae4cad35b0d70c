#ifndef LATTICEWORLD_EXPORTING_MAP_SERVER_H_
#define LATTICEWORLD_EXPORTING_MAP_SERVER_H_

#include <cstdint>
#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

struct MapServerFiles {
  std::string pgm;   // content of map.pgm
  std::string yaml;  // content of map.yaml, naming map.pgm
};
// occupancy: 0..100, -1 unknown. Files as ROS map_server reads them (mode: scale).
Result<MapServerFiles> ToMapServer(const Grid<std::int8_t>& occupancy,
                                   const GridGeometry& geometry);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_MAP_SERVER_H_
