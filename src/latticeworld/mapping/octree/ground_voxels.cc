#include "latticeworld/mapping/octree/ground_voxels.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

// floor(height * voxels_per_m), written so that compilers vectorise it for any x86-64.
inline std::int16_t VoxelOf(double height_m, double voxels_per_m) {
  const double exact = height_m * voxels_per_m;
  const int truncated = static_cast<int>(exact);
  return static_cast<std::int16_t>(truncated - (exact < truncated ? 1 : 0));
}

}  // namespace

GroundVoxels::GroundVoxels(const HeightField& ground, double voxel_m, const VoxelBox& columns)
    : ground_(ground), voxels_per_m_(1.0 / voxel_m), x_low_(columns.x_low), y_low_(columns.y_low) {
  const GridGeometry& geometry = ground.geometry();
  const double last = geometry.rows() - 1;
  // Places are found as HeightField finds them.
  const auto place_of = [&](double continuous) {
    const double inside = std::clamp(continuous, 0.0, last);
    const int vertex = std::min(static_cast<int>(inside), geometry.rows() - 2);
    return Place{vertex, inside - vertex};
  };
  for (int x = columns.x_low; x <= columns.x_high; ++x)
    x_places_.push_back(place_of(geometry.ColOf(VoxelCenter_m(x, voxel_m))));
  for (int y = columns.y_low; y <= columns.y_high; ++y)
    y_places_.push_back(place_of(geometry.RowOf(VoxelCenter_m(y, voxel_m))));
  while (on_vertices_ < static_cast<int>(x_places_.size()) &&
         x_places_[on_vertices_].share == 0.0 &&
         x_places_[on_vertices_].vertex == x_places_[0].vertex + on_vertices_)
    ++on_vertices_;
}

void GroundVoxels::SampleRow(int y, int x_low, int x_high, std::int16_t* surface) const {
  const Place row = y_places_[y - y_low_];
  const float* north = ground_.height_m().row(row.vertex);
  const float* south = ground_.height_m().row(row.vertex + 1);
  const int count = x_high - x_low + 1;
  const Place* places = x_places_.data() + (x_low - x_low_);
  const double voxels_per_m = voxels_per_m_;
  // Columns that stand on vertices of this row need no interpolation.
  int x = 0;
  if (row.share == 0.0) {
    const int plain = std::clamp(on_vertices_ - (x_low - x_low_), 0, count);
    const float* heights = plain > 0 ? north + places[0].vertex : north;
    for (; x < plain; ++x) surface[x] = VoxelOf(heights[x], voxels_per_m);
  }
  const double v = row.share;
  for (; x < count; ++x) {
    const int c = places[x].vertex;
    const double u = places[x].share;
    const double north_west = north[c], north_east = north[c + 1];
    const double south_west = south[c], south_east = south[c + 1];
    const bool upper = u >= v;  // the north-east triangle
    const double dz_du = upper ? north_east - north_west : south_east - south_west;
    const double dz_dv = upper ? south_east - north_east : south_west - north_west;
    surface[x] = VoxelOf(north_west + u * dz_du + v * dz_dv, voxels_per_m);
  }
}

}  // namespace latticeworld
