#include "latticeworld/simulation/footprint.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {

double DistanceToElement(const Element& element, WorldPoint at, double yaw_rad, WorldPoint point) {
  const double dx = point.x_m - at.x_m, dy = point.y_m - at.y_m;
  double along_m = std::cos(yaw_rad) * dx + std::sin(yaw_rad) * dy;
  const double across_m = std::cos(yaw_rad) * dy - std::sin(yaw_rad) * dx;
  // A gate's origin is at its hinge, at one end of its panel.
  if (element.kind == ElementKind::kGate) along_m -= 0.5 * element.size_m.x();
  return std::hypot(std::max(0.0, std::abs(along_m) - 0.5 * element.size_m.x()),
                    std::max(0.0, std::abs(across_m) - 0.5 * element.size_m.y()));
}

double DistanceToStem(const FallenTree& tree, WorldPoint point) {
  const Eigen::Vector2d foot = tree.foot_m.head<2>(), way = tree.tip_m.head<2>() - foot;
  const Eigen::Vector2d to_point = Eigen::Vector2d(point.x_m, point.y_m) - foot;
  const double length2_m2 = way.squaredNorm();
  const double share =
      length2_m2 > 0.0 ? std::clamp(to_point.dot(way) / length2_m2, 0.0, 1.0) : 0.0;
  return (to_point - share * way).norm();
}

}  // namespace latticeworld
