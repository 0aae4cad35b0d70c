#include "latticeworld/exporting/oblique_camera.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr float kHighestEye_rad = 0.74f;  // lower where mountains need the room
constexpr float kLowestEye_rad = 0.5f;
constexpr float kEyeStep_rad = 0.03f;
constexpr float kStandOff = 3.2f;       // from the south edge, in world sizes
constexpr float kLargestWidth = 0.95f;  // of the picture that the world may take
constexpr float kLargestHeight = 0.92f;
constexpr float kBottomMargin = 0.05f;  // of the picture, below the world
constexpr float kHighestFlyer = 0.15f;  // in world sizes; pins of higher ones end at the frame

}  // namespace

ObliqueCamera::ObliqueCamera(const Scene& scene, const ShadedGround& ground, float skirt_m,
                             int width_px, int height_px) {
  const float size_m = static_cast<float>(scene.geometry().size_m());
  eye_y_m_ = -(kStandOff + 0.5f) * size_m;
  center_x_px_ = 0.5f * width_px;
  // The highest eye that still fits the world by its width, if any does.
  const float slimmest = kLargestHeight * height_px / (kLargestWidth * width_px);
  Extent extent;
  elevation_rad_ = kHighestEye_rad;
  for (;; elevation_rad_ -= kEyeStep_rad) {
    eye_z_m_ = (kStandOff + 0.5f) * size_m * std::tan(elevation_rad_);
    extent = ExtentOf(scene, ground, skirt_m);
    if (extent.bottom - extent.top <= slimmest * extent.width) break;
    if (elevation_rad_ - kEyeStep_rad < kLowestEye_rad) break;
  }
  focal_px_ = std::min(kLargestWidth * width_px / extent.width,
                       kLargestHeight * height_px / (extent.bottom - extent.top));
  // Flat worlds stand in the middle, but for a little more sky above.
  const float free_px = height_px - focal_px_ * (extent.bottom - extent.top);
  const float below_px = std::max(kBottomMargin * height_px, 0.4f * free_px);
  center_y_px_ = height_px - std::min(below_px, 0.6f * free_px) - focal_px_ * extent.bottom;
}

ObliqueCamera::Extent ObliqueCamera::ExtentOf(const Scene& scene, const ShadedGround& ground,
                                              float skirt_m) const {
  const GridGeometry& geometry = scene.geometry();
  const float size_m = static_cast<float>(geometry.size_m());
  const auto line_of = [&](float y_m, float z_m) { return (eye_z_m_ - z_m) / DistanceOf(y_m); };
  const auto ground_at = [&](WorldPoint point) {
    const CellIndex cell = geometry.CellAt(point);
    return ground.surface_m.at<float>(std::clamp(cell.row, 0, geometry.rows() - 1),
                                      std::clamp(cell.col, 0, geometry.cols() - 1));
  };
  const float near_m = DistanceOf(-0.5f * size_m);
  Extent extent = {size_m / near_m, 1e9f, (eye_z_m_ + skirt_m) / near_m};
  for (int row = 0; row < geometry.rows(); ++row) {
    const float* z_m = ground.surface_m.ptr<float>(row);
    const float y_m = static_cast<float>(geometry.CenterOf({row, 0}).y_m);
    extent.top = std::min(extent.top, line_of(y_m, *std::max_element(z_m, z_m + geometry.cols())));
  }
  const float high_m = kHighestFlyer * size_m;
  for (const Asset& asset : scene.assets) {
    const float z_m = ground_at(asset.position()) + std::min(asset.height_m, high_m);
    extent.top = std::min(extent.top, line_of(asset.y_m, z_m));
  }
  for (const AgentStart& agent : scene.agents) {
    const float up_m = std::min(static_cast<float>(agent.height_above_ground_m), high_m);
    const float z_m = ground_at(agent.position) + up_m;
    extent.top = std::min(extent.top, line_of(static_cast<float>(agent.position.y_m), z_m));
  }
  return extent;
}

ViewAxes ObliqueCamera::axes() const {
  const float c = std::cos(elevation_rad_), s = std::sin(elevation_rad_);
  return {Eigen::Vector3f::UnitX(), Eigen::Vector3f(0.0f, s, c), Eigen::Vector3f(0.0f, -c, s)};
}

}  // namespace latticeworld
