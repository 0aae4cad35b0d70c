#ifndef LATTICEWORLD_ROS_GRID_CONVERSION_H_
#define LATTICEWORLD_ROS_GRID_CONVERSION_H_

#include <grid_map_msgs/GridMap.h>
#include <nav_msgs/OccupancyGrid.h>
#include <sensor_msgs/Image.h>

#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

// Frames are map, stamps are left at zero: who publishes sets them.

struct GridLayer {
  std::string name;
  const Grid<float>* values = nullptr;  // (rows x cols) of the geometry, NaN: unknown
};

// grid_map's layout: column-major, cell (0, 0) in the +x +y corner, the first index grows toward
// -x, the second toward -y. basic_layers is the first layer.
grid_map_msgs::GridMap ToGridMap(const GridGeometry& geometry,
                                 const std::vector<GridLayer>& layers);

// Row-major from the lower left (south-west) corner, whose place is the origin. occupancy:
// (rows x cols) of the geometry, row 0 north, -1 and 0..100.
nav_msgs::OccupancyGrid ToOccupancyGrid(const GridGeometry& geometry,
                                        const Grid<std::int8_t>& occupancy);

// 32FC1, row 0 north, values as they are.
sensor_msgs::Image ToImage(const Grid<float>& values);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_GRID_CONVERSION_H_
