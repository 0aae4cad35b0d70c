#include "latticeworld/exporting/oblique_camera.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr float kElevation_rad = 0.74f;  // of the camera above the world's middle
constexpr float kStandOff = 1.2f;        // from the south edge, in world sizes
constexpr float kLargestWidth = 0.97f;   // of the picture that the world may take
constexpr float kLargestHeight = 0.88f;
constexpr float kTallAsset_m = 12.0f;  // room above the ground

}  // namespace

ObliqueCamera::ObliqueCamera(const Scene& scene, const ShadedGround& ground, float skirt_m,
                             int width_px, int height_px) {
  const GridGeometry& geometry = scene.geometry();
  const float size_m = static_cast<float>(geometry.size_m());
  const float half_m = 0.5f * size_m;
  eye_y_m_ = -half_m - kStandOff * size_m;
  eye_z_m_ = (kStandOff + 0.5f) * size_m * std::tan(kElevation_rad);

  // Extent of the picture at a focal length of one pixel.
  focal_px_ = 1.0f;
  float top = 1e9f;
  constexpr int kSamples = 96;
  for (int i = 0; i <= kSamples; ++i) {
    for (int j = 0; j <= kSamples; ++j) {
      const int row = i * (geometry.rows() - 1) / kSamples,
                col = j * (geometry.cols() - 1) / kSamples;
      const float y_m = static_cast<float>(geometry.CenterOf({row, col}).y_m);
      const float z_m = ground.surface_m.at<float>(row, col) + kTallAsset_m;
      top = std::min(top, Project(0.0f, DistanceOf(y_m), z_m).y());
    }
  }
  const float bottom = Project(0.0f, DistanceOf(-half_m), -skirt_m).y();
  const float width = size_m / DistanceOf(-half_m);
  focal_px_ =
      std::min(kLargestWidth * width_px / width, kLargestHeight * height_px / (bottom - top));
  center_x_px_ = 0.5f * width_px;
  // The world stands a little below the middle, under its sky.
  center_y_px_ = 0.52f * height_px - focal_px_ * 0.5f * (top + bottom);
}

ViewAxes ObliqueCamera::axes() const {
  const float c = std::cos(kElevation_rad), s = std::sin(kElevation_rad);
  return {Eigen::Vector3f::UnitX(), Eigen::Vector3f(0.0f, s, c), Eigen::Vector3f(0.0f, -c, s)};
}

}  // namespace latticeworld
