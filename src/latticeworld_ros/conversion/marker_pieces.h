#ifndef LATTICEWORLD_ROS_CONVERSION_MARKER_PIECES_H_
#define LATTICEWORLD_ROS_CONVERSION_MARKER_PIECES_H_

#include <geometry_msgs/Point.h>
#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/Marker.h>

#include <cstddef>
#include <string>
#include <vector>

#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

// Triangles of one namespace, gathered in square tiles over the world, so that rviz draws only the
// pieces in view and no piece grows without bound.
class MarkerPieces {
 public:
  static constexpr double kTile_m = 64.0;  // at least; worlds have at most kMaxTiles^2 tiles
  static constexpr int kMaxTiles = 16;
  static constexpr std::size_t kMaxTriangles = 20000;  // of one marker

  MarkerPieces(std::string ns, double world_size_m);

  // What is added next belongs to the tile of this place.
  void MoveTo(WorldPoint place);
  void Add(const geometry_msgs::Point& a, const geometry_msgs::Point& b,
           const geometry_msgs::Point& c, const std_msgs::ColorRGBA& color);

  // One marker a tile that has triangles, further ones where it has more than kMaxTriangles; ids
  // count up from 0. Frame map, stamps left at zero.
  std::vector<visualization_msgs::Marker> Take();

 private:
  struct Tile {
    std::vector<geometry_msgs::Point> points;
    std::vector<std_msgs::ColorRGBA> colors;  // one a triangle
  };

  std::string ns_;
  double half_size_m_;
  double tile_m_;
  int tiles_;  // a side
  std::vector<Tile> content_;
  Tile* current_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_MARKER_PIECES_H_
