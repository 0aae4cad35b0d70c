#include "latticeworld_ros/conversion/marker_pieces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld_ros/conversion/geometry_conversion.h"

namespace latticeworld {

MarkerPieces::MarkerPieces(std::string ns, double world_size_m)
    : ns_(std::move(ns)),
      half_size_m_(0.5 * world_size_m),
      tile_m_(std::max(kTile_m, world_size_m / kMaxTiles)),
      tiles_(static_cast<int>(std::ceil(world_size_m / tile_m_))),
      content_(static_cast<std::size_t>(tiles_ * tiles_)),
      current_(content_.data()) {}

void MarkerPieces::MoveTo(WorldPoint place) {
  const auto tile_of = [this](double coordinate_m) {
    return std::clamp(static_cast<int>((coordinate_m + half_size_m_) / tile_m_), 0, tiles_ - 1);
  };
  current_ = &content_[static_cast<std::size_t>(tile_of(place.y_m) * tiles_ + tile_of(place.x_m))];
}

void MarkerPieces::Add(const geometry_msgs::Point& a, const geometry_msgs::Point& b,
                       const geometry_msgs::Point& c, const std_msgs::ColorRGBA& color) {
  current_->points.insert(current_->points.end(), {a, b, c});
  current_->colors.push_back(color);
}

std::vector<visualization_msgs::Marker> MarkerPieces::Take() {
  using visualization_msgs::Marker;
  std::vector<Marker> markers;
  for (Tile& tile : content_) {
    for (std::size_t begin = 0; begin < tile.colors.size(); begin += kMaxTriangles) {
      const std::size_t end = std::min(begin + kMaxTriangles, tile.colors.size());
      Marker marker;
      marker.header.frame_id = kMapFrame;
      marker.ns = ns_;
      marker.id = static_cast<int>(markers.size());
      marker.type = Marker::TRIANGLE_LIST;
      marker.action = Marker::ADD;
      marker.pose.orientation.w = 1.0;
      marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
      marker.color.r = marker.color.g = marker.color.b = marker.color.a = 1.0f;
      marker.points.assign(tile.points.begin() + static_cast<std::ptrdiff_t>(3 * begin),
                           tile.points.begin() + static_cast<std::ptrdiff_t>(3 * end));
      marker.colors.assign(tile.colors.begin() + static_cast<std::ptrdiff_t>(begin),
                           tile.colors.begin() + static_cast<std::ptrdiff_t>(end));
      markers.push_back(std::move(marker));
    }
    tile = Tile();
  }
  return markers;
}

}  // namespace latticeworld
