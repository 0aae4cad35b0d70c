#include "latticeworld/rendering/views/oblique_camera.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr float kHighestEye_rad = 0.74f;  // lower where mountains need the room
constexpr float kLowestEye_rad = 0.5f;
constexpr float kEyeStep_rad = 0.03f;
constexpr float kStandOff = 2.8f;       // from the south edge, in world sizes
constexpr float kLargestWidth = 0.95f;  // of the picture that the world may take
constexpr float kLargestHeight = 0.92f;
constexpr float kBottomMargin = 0.05f;  // of the picture, below the world
constexpr float kHighestFlyer = 0.15f;  // in world sizes; pins of higher ones end at the frame

// What the world takes up, at a focal length of one pixel.
struct Extent {
  float width;
  float top;
  float bottom;
};

Extent ExtentOf(const Scene& scene, const Eigen::Vector3f& eye_m, float block_m) {
  const GridGeometry& geometry = scene.geometry();
  const HeightField& ground = scene.terrain->ground;
  const float half_m = static_cast<float>(geometry.half_size_m());
  const auto line_of = [&](double y_m, double z_m) {
    return static_cast<float>((eye_m.z() - z_m) / (y_m - eye_m.y()));
  };
  const float near_m = -half_m - eye_m.y();
  Extent extent = {2.0f * half_m / near_m, 1e9f, line_of(-half_m, ground.min_m() - block_m)};
  for (int row = 0; row < geometry.rows(); ++row) {
    const float* z_m = ground.height_m().row(row);
    const double y_m = geometry.CenterOf({row, 0}).y_m;
    extent.top = std::min(extent.top, line_of(y_m, *std::max_element(z_m, z_m + geometry.cols())));
  }
  for (const Asset& asset : scene.assets)
    extent.top = std::min(extent.top, line_of(asset.y_m, asset.z_m + asset.height_m));
  const float high_m = 2.0f * kHighestFlyer * half_m;
  for (const AgentStart& agent : scene.agents) {
    const float up_m = std::min(static_cast<float>(agent.height_above_ground_m), high_m);
    extent.top =
        std::min(extent.top, line_of(agent.position.y_m, ground.HeightAt(agent.position) + up_m));
  }
  return extent;
}

}  // namespace

RayCamera ObliqueCamera(const Scene& scene, float block_m, int width_px, int height_px) {
  const float size_m = static_cast<float>(scene.geometry().size_m());
  const float base_m = scene.terrain->ground.min_m();
  // The highest eye that still fits the world by its width, if any does.
  const float slimmest = kLargestHeight * static_cast<float>(height_px) /
                         (kLargestWidth * static_cast<float>(width_px));
  Eigen::Vector3f eye_m;
  Extent extent;
  for (float elevation_rad = kHighestEye_rad;; elevation_rad -= kEyeStep_rad) {
    eye_m = {0.0f, -(kStandOff + 0.5f) * size_m,
             base_m + (kStandOff + 0.5f) * size_m * std::tan(elevation_rad)};
    extent = ExtentOf(scene, eye_m, block_m);
    if (extent.bottom - extent.top <= slimmest * extent.width) break;
    if (elevation_rad - kEyeStep_rad < kLowestEye_rad) break;
  }
  const float focal_px =
      std::min(kLargestWidth * static_cast<float>(width_px) / extent.width,
               kLargestHeight * static_cast<float>(height_px) / (extent.bottom - extent.top));
  // Flat worlds stand in the middle, but for a little more sky above.
  const float height = static_cast<float>(height_px);
  const float free_px = height - focal_px * (extent.bottom - extent.top);
  const float below_px = std::max(kBottomMargin * height, 0.4f * free_px);
  const float center_y_px = height - std::min(below_px, 0.6f * free_px) - focal_px * extent.bottom;
  return RayCamera::FacingNorth(eye_m, focal_px,
                                {0.5f * static_cast<float>(width_px), center_y_px});
}

}  // namespace latticeworld
