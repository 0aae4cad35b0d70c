#include "latticeworld/geometry/height_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/common/check.h"

namespace latticeworld {

HeightField::HeightField(GridGeometry geometry, Grid<float> height_m)
    : geometry_(geometry), height_m_(std::move(height_m)) {
  LW_CHECK(height_m_.rows() == geometry_.rows() && height_m_.cols() == geometry_.cols() &&
               geometry_.rows() >= 2,
           "a height field needs a height for every cell of its geometry");
  const auto range = std::minmax_element(height_m_.begin(), height_m_.end());
  min_m_ = *range.first;
  max_m_ = *range.second;
}

HeightField::Sample HeightField::SampleAt(WorldPoint point) const {
  const double last = geometry_.rows() - 1;
  const double row = std::clamp(geometry_.RowOf(point.y_m), 0.0, last);
  const double col = std::clamp(geometry_.ColOf(point.x_m), 0.0, last);
  const int r = std::min(static_cast<int>(row), geometry_.rows() - 2);
  const int c = std::min(static_cast<int>(col), geometry_.cols() - 2);
  const double v = row - r;  // southward
  const double u = col - c;  // eastward
  const double north_west = height_m_(r, c);
  const double north_east = height_m_(r, c + 1);
  const double south_west = height_m_(r + 1, c);
  const double south_east = height_m_(r + 1, c + 1);
  double dz_du;
  double dz_dv;
  if (u >= v) {  // north-east triangle
    dz_du = north_east - north_west;
    dz_dv = south_east - north_east;
  } else {  // south-west triangle
    dz_du = south_east - south_west;
    dz_dv = south_west - north_west;
  }
  return {north_west + u * dz_du + v * dz_dv, dz_du / geometry_.resolution_m(),
          -dz_dv / geometry_.resolution_m()};
}

double HeightField::HeightAt(WorldPoint point) const { return SampleAt(point).height_m; }

Eigen::Vector3d HeightField::NormalAt(WorldPoint point) const {
  const Sample sample = SampleAt(point);
  return Eigen::Vector3d(-sample.dz_dx, -sample.dz_dy, 1.0).normalized();
}

double HeightField::SlopeAt(WorldPoint point) const {
  const Sample sample = SampleAt(point);
  return std::atan(std::hypot(sample.dz_dx, sample.dz_dy));
}

}  // namespace latticeworld
