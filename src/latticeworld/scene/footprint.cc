#include "latticeworld/scene/footprint.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

// The largest gap between the shadows of two rectangles on the axes of the first: positive where
// one of these axes separates them.
double SeparationOnAxesOf(const Footprint& a, const std::array<WorldPoint, 4>& b) {
  double separation_m = -INFINITY;
  for (int axis = 0; axis < 2; ++axis) {
    const double angle_rad = a.yaw_rad + axis * 0.5 * M_PI;
    const double x = std::cos(angle_rad), y = std::sin(angle_rad);
    const double half_m = axis == 0 ? a.half_length_m : a.half_width_m;
    double low_m = INFINITY, high_m = -INFINITY;
    for (const WorldPoint& corner : b) {
      const double at_m = x * (corner.x_m - a.centre.x_m) + y * (corner.y_m - a.centre.y_m);
      low_m = std::min(low_m, at_m);
      high_m = std::max(high_m, at_m);
    }
    separation_m = std::max({separation_m, low_m - half_m, -half_m - high_m});
  }
  return separation_m;
}

}  // namespace

double Footprint::radius_m() const { return std::hypot(half_length_m, half_width_m); }

WorldPoint Footprint::At(double along_m, double left_m) const {
  const double cosine = std::cos(yaw_rad), sine = std::sin(yaw_rad);
  return {centre.x_m + cosine * along_m - sine * left_m,
          centre.y_m + sine * along_m + cosine * left_m};
}

std::array<WorldPoint, 4> Footprint::Corners() const {
  return {At(half_length_m, half_width_m), At(half_length_m, -half_width_m),
          At(-half_length_m, -half_width_m), At(-half_length_m, half_width_m)};
}

Footprint FootprintOf(const Asset& building) {
  return {building.position(), building.yaw_rad, building.half_length_m, building.half_width_m};
}

double GapTo(const Footprint& footprint, WorldPoint point) {
  const double dx = point.x_m - footprint.centre.x_m, dy = point.y_m - footprint.centre.y_m;
  const double cosine = std::cos(footprint.yaw_rad), sine = std::sin(footprint.yaw_rad);
  const double along_m = std::abs(cosine * dx + sine * dy) - footprint.half_length_m;
  const double across_m = std::abs(-sine * dx + cosine * dy) - footprint.half_width_m;
  if (along_m < 0.0 && across_m < 0.0) return std::max(along_m, across_m);
  return std::hypot(std::max(along_m, 0.0), std::max(across_m, 0.0));
}

double GapBetween(const Footprint& a, const Footprint& b) {
  const std::array<WorldPoint, 4> corners_a = a.Corners(), corners_b = b.Corners();
  const double separation_m =
      std::max(SeparationOnAxesOf(a, corners_b), SeparationOnAxesOf(b, corners_a));
  if (separation_m <= 0.0) return separation_m;
  // The nearest points of two rectangles that do not overlap are a corner and a point of a side.
  double gap_m = INFINITY;
  for (const WorldPoint& corner : corners_b) gap_m = std::min(gap_m, GapTo(a, corner));
  for (const WorldPoint& corner : corners_a) gap_m = std::min(gap_m, GapTo(b, corner));
  return gap_m;
}

}  // namespace latticeworld
