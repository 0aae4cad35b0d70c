#include "latticeworld/rendering/ray/ray_camera.h"

#include <Eigen/Geometry>
#include <cmath>

namespace latticeworld {

using Eigen::Vector2f;
using Eigen::Vector3f;

RayCamera RayCamera::Looking(const Vector3f& eye_m, float heading_rad, float pitch_rad,
                             float field_of_view_rad, int width_px, int height_px) {
  RayCamera camera;
  camera.eye_m_ = eye_m;
  camera.forward_ = Vector3f(std::cos(pitch_rad) * std::cos(heading_rad),
                             std::cos(pitch_rad) * std::sin(heading_rad), std::sin(pitch_rad));
  camera.right_ = Vector3f(std::sin(heading_rad), -std::cos(heading_rad), 0.0f);
  camera.up_ = camera.right_.cross(camera.forward_);
  camera.focal_px_ = 0.5f * static_cast<float>(width_px) / std::tan(0.5f * field_of_view_rad);
  camera.center_px_ = {0.5f * static_cast<float>(width_px), 0.5f * static_cast<float>(height_px)};
  return camera;
}

RayCamera RayCamera::FacingNorth(const Vector3f& eye_m, float focal_px, const Vector2f& center_px) {
  RayCamera camera;
  camera.eye_m_ = eye_m;
  camera.forward_ = Vector3f::UnitY();
  camera.right_ = Vector3f::UnitX();
  camera.up_ = Vector3f::UnitZ();
  camera.focal_px_ = focal_px;
  camera.center_px_ = center_px;
  return camera;
}

Vector3f RayCamera::DirectionAt(float x_px, float y_px) const {
  const float x = (x_px - center_px_.x()) / focal_px_, y = (center_px_.y() - y_px) / focal_px_;
  return (forward_ + x * right_ + y * up_).normalized();
}

Vector2f RayCamera::Project(const Vector3f& point_m) const {
  const Vector3f to = point_m - eye_m_;
  const float scale = focal_px_ / to.dot(forward_);
  return {center_px_.x() + scale * to.dot(right_), center_px_.y() - scale * to.dot(up_)};
}

}  // namespace latticeworld
