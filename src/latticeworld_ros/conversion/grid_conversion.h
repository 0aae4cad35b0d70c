#ifndef LATTICEWORLD_ROS_CONVERSION_GRID_CONVERSION_H_
#define LATTICEWORLD_ROS_CONVERSION_GRID_CONVERSION_H_

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

// What of several cells stands for them where a layer is made coarser. NaN counts only where all
// are NaN.
enum class CellMerge : std::uint8_t { kMean, kLeast, kMost };

struct GridLayer {
  std::string name;
  const Grid<float>* values = nullptr;  // (rows x cols) of the geometry, NaN: unknown
  CellMerge merge = CellMerge::kMean;
};

// The least power of two by which a grid map of so many cells a side and layers is to be made
// coarser so that its message has fewer than most_bytes.
int CoarseningFor(int cells, std::size_t layers, std::uint64_t most_bytes);

// grid_map's layout: column-major, cell (0, 0) in the +x +y corner, the first index grows toward
// -x, the second toward -y. basic_layers is the first layer. coarsening: cells of the geometry a
// side of one of the message; where they do not go into the side evenly, the map reaches beyond the
// east and the south edge, and its pose is its own centre.
grid_map_msgs::GridMap ToGridMap(const GridGeometry& geometry, const std::vector<GridLayer>& layers,
                                 int coarsening = 1);

// Row-major from the lower left (south-west) corner, whose place is the origin. occupancy:
// (rows x cols) of the geometry, row 0 north, -1 and 0..100.
nav_msgs::OccupancyGrid ToOccupancyGrid(const GridGeometry& geometry,
                                        const Grid<std::int8_t>& occupancy);

// 32FC1, row 0 north, values as they are.
sensor_msgs::Image ToImage(const Grid<float>& values);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_GRID_CONVERSION_H_
