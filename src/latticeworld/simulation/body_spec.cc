#include "latticeworld/simulation/body_spec.h"

#include <algorithm>

namespace latticeworld {
namespace {

double ReachOf(const BodyShape& shape) {
  switch (shape.form) {
    case ShapeForm::kBall:
      return shape.center_m.norm() + shape.radius_m;
    case ShapeForm::kCapsule: {
      const Eigen::Vector3d half =
          shape.orientation * Eigen::Vector3d(0.0, 0.0, shape.half_length_m);
      return std::max((shape.center_m + half).norm(), (shape.center_m - half).norm()) +
             shape.radius_m;
    }
    case ShapeForm::kBox:
      break;
  }
  double reach_m = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    Eigen::Vector3d at = shape.half_extents_m;
    for (int axis = 0; axis < 3; ++axis) {
      if ((corner >> axis & 1) != 0) at[axis] = -at[axis];
    }
    reach_m = std::max(reach_m, (shape.center_m + shape.orientation * at).norm());
  }
  return reach_m;
}

}  // namespace

double BodySpec::total_mass_kg() const {
  double total_kg = mass_kg;
  for (const WheelSpec& wheel : wheels) total_kg += wheel.mass_kg;
  for (const LinkSpec& link : links) total_kg += link.mass_kg;
  return total_kg;
}

double BodySpec::reach_m() const {
  double reach_m = 0.0;
  for (const BodyShape& shape : shapes) reach_m = std::max(reach_m, ReachOf(shape));
  for (const WheelSpec& wheel : wheels) {
    reach_m = std::max(reach_m, wheel.center_m.norm() + wheel.radius_m);
  }
  return reach_m;
}

}  // namespace latticeworld
