#include "latticeworld/rendering/looks/ground_shading.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "latticeworld/rendering/looks/picture_style.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// 1 in the sun .. 0 in the shadow of the land: a sweep away from the light carries the height of
// the shadow's edge from line to line, falling with the distance.
cv::Mat LandInSun(const cv::Mat& height_m, double cell_m, const Eigen::Vector3f& towards_light) {
  // Work with the light in the north or, transposed, in the west; flip where it is not.
  const bool transpose = std::abs(towards_light.x()) > std::abs(towards_light.y());
  cv::Mat heights = transpose ? cv::Mat(height_m.t()) : height_m.clone();
  const float major = transpose ? -towards_light.x() : towards_light.y();  // > 0: from row 0
  const float minor = transpose ? -towards_light.y() : towards_light.x();  // > 0: from larger cols
  const bool flip = major < 0.0f;
  if (flip) cv::flip(heights, heights, 0);

  const float shift = minor / std::max(std::abs(major), 1e-6f);
  const float horizontal = std::hypot(major, minor);
  const float fall_m = static_cast<float>(cell_m) * std::hypot(1.0f, shift) * towards_light.z() /
                       std::max(horizontal, 1e-6f);
  cv::Mat sun(heights.size(), CV_32FC1, cv::Scalar(1.0));
  std::vector<float> edge(heights.ptr<float>(0), heights.ptr<float>(0) + heights.cols);
  std::vector<float> next(edge.size());
  const float penumbra_m = static_cast<float>(0.6 * cell_m + 0.2);
  for (int row = 1; row < heights.rows; ++row) {
    const float* here = heights.ptr<float>(row);
    float* lit = sun.ptr<float>(row);
    for (int col = 0; col < heights.cols; ++col) {
      const float from = std::clamp(col + shift, 0.0f, heights.cols - 1.001f);
      const int left = static_cast<int>(from);
      const float share = from - left;
      const float shadow_m = edge[left] * (1.0f - share) + edge[left + 1] * share - fall_m;
      lit[col] = 1.0f - std::clamp((shadow_m - here[col]) / penumbra_m, 0.0f, 1.0f);
      next[col] = std::max(shadow_m, here[col]);
    }
    edge.swap(next);
  }
  if (flip) cv::flip(sun, sun, 0);
  return transpose ? cv::Mat(sun.t()) : sun;
}

// Darkens what assets keep from the light.
class AssetShadows {
 public:
  AssetShadows(const GridGeometry& geometry, const Eigen::Vector3f& towards_light, float dark,
               cv::Mat* sun)
      : geometry_(geometry), dark_(dark), sun_(sun) {
    const float reach = std::min(2.2f, towards_light.head<2>().norm() / towards_light.z());
    away_ = -towards_light.head<2>().normalized() * reach;
  }

  void Add(const Asset& asset) {
    const Eigen::Vector2f at(asset.x_m, asset.y_m);
    if (asset.kind == AssetKind::kBuilding) {
      AddBox(asset, at);
    } else if (asset.kind == AssetKind::kTree) {
      AddCapsule(at + away_ * (0.3f * asset.height_m), at + away_ * (0.8f * asset.height_m),
                 0.85f * asset.half_length_m, dark_);
    } else if (asset.kind == AssetKind::kBush || asset.kind == AssetKind::kStone) {
      AddCapsule(at, at + away_ * (0.6f * asset.height_m), asset.half_length_m, 0.8f * dark_);
    }
  }

 private:
  static constexpr int kFraction = 4;  // bits of OpenCV's fixed-point coordinates
  cv::Point PixelOf(const Eigen::Vector2f& at) const {
    return {static_cast<int>(std::lround(geometry_.ColOf(at.x()) * (1 << kFraction))),
            static_cast<int>(std::lround(geometry_.RowOf(at.y()) * (1 << kFraction)))};
  }

  void AddBox(const Asset& asset, const Eigen::Vector2f& at) {
    const Eigen::Vector2f along(std::cos(asset.yaw_rad), std::sin(asset.yaw_rad));
    const Eigen::Vector2f across(-along.y(), along.x());
    std::vector<cv::Point> corners;
    for (const float height_m : {0.0f, asset.height_m}) {
      for (int i = 0; i < 4; ++i) {
        const float l = i & 1 ? asset.half_length_m : -asset.half_length_m;
        const float w = i & 2 ? asset.half_width_m : -asset.half_width_m;
        corners.push_back(PixelOf(at + along * l + across * w + away_ * height_m));
      }
    }
    std::vector<cv::Point> hull;
    cv::convexHull(corners, hull);
    cv::fillConvexPoly(*sun_, hull, cv::Scalar(1.0 - dark_), cv::LINE_8, kFraction);
  }

  // Multiplies, cell by cell, within radius of a segment; soft at the rim.
  void AddCapsule(const Eigen::Vector2f& from, const Eigen::Vector2f& to, float radius_m,
                  float dark) {
    const float cell_m = static_cast<float>(geometry_.resolution_m());
    const Eigen::Vector2f a(geometry_.ColOf(from.x()), geometry_.RowOf(from.y()));
    const Eigen::Vector2f b(geometry_.ColOf(to.x()), geometry_.RowOf(to.y()));
    const float radius = radius_m / cell_m;
    const Eigen::Vector2f low = a.cwiseMin(b).array() - radius - 1.0f;
    const Eigen::Vector2f high = a.cwiseMax(b).array() + radius + 1.0f;
    const Eigen::Vector2f ab = b - a;
    const float length2 = std::max(ab.squaredNorm(), 1e-6f);
    for (int row = std::max(0, static_cast<int>(low.y()));
         row <= std::min(sun_->rows - 1, static_cast<int>(high.y())); ++row) {
      float* lit = sun_->ptr<float>(row);
      for (int col = std::max(0, static_cast<int>(low.x()));
           col <= std::min(sun_->cols - 1, static_cast<int>(high.x())); ++col) {
        const Eigen::Vector2f ap(col - a.x(), row - a.y());
        const float t = std::clamp(ap.dot(ab) / length2, 0.0f, 1.0f);
        const float inside = std::clamp(radius + 0.5f - (ap - t * ab).norm(), 0.0f, 1.0f);
        lit[col] = std::min(lit[col], 1.0f - dark * inside);
      }
    }
  }

  const GridGeometry& geometry_;
  const float dark_;
  cv::Mat* sun_;
  Eigen::Vector2f away_;  // shadow's run per metre of height
};

Color WaterColor(const Scene& scene, float depth_m) {
  const Color shallow = FromRgb(104, 158, 160), deep = FromRgb(30, 84, 126);
  Color water = Mix(shallow, deep, 1.0f - std::exp(-0.55f * depth_m));
  if (scene.environment.coarse.season == Season::kWinter && scene.atmosphere.snow_depth_m > 0.0)
    water = Mix(water, FromRgb(186, 208, 222), 0.55f);  // ice
  return InStyle(scene.environment.coarse.artistic_style, water);
}

}  // namespace

float ReliefExaggeration(const Scene& scene) {
  const HeightField& ground = scene.terrain->ground;
  const double range_m = std::max(0.5, static_cast<double>(ground.max_m()) - ground.min_m());
  return static_cast<float>(std::clamp(0.1 * scene.geometry().size_m() / range_m, 1.0, 3.5));
}

cv::Mat ShadeGround(const Scene& scene, const GroundMaterials& materials,
                    const PictureLight& light) {
  const Terrain& terrain = *scene.terrain;
  const GridGeometry& geometry = terrain.geometry();
  const int rows = geometry.rows(), cols = geometry.cols();
  const double cell_m = geometry.resolution_m();
  const float stretch = ReliefExaggeration(scene);

  const cv::Mat& depth_m = materials.water_depth_m;
  const cv::Mat ground_m(rows, cols, CV_32FC1,
                         const_cast<float*>(terrain.ground.height_m().data()));
  const cv::Mat level_m = ground_m + depth_m;

  // Hollows are darker than crests: the difference to a smoothed relief.
  cv::Mat small, smooth_m;
  cv::resize(level_m, small, {}, 0.125, 0.125, cv::INTER_AREA);
  cv::GaussianBlur(small, small, {}, std::max(0.6, 14.0 / (8.0 * cell_m)));
  cv::resize(small, smooth_m, level_m.size(), 0, 0, cv::INTER_LINEAR);

  cv::Mat sun = LandInSun(stretch * level_m, cell_m, light.direction);
  sun = 1.0f - light.shadow * (1.0f - sun);
  AssetShadows shadows(geometry, light.direction, 0.75f * light.shadow, &sun);
  for (const Asset& asset : scene.assets) shadows.Add(asset);
  cv::GaussianBlur(sun, sun, {}, std::max(0.5, 0.35 / cell_m));

  cv::Mat color = materials.color.clone();
  const cv::Mat ripples = SmoothNoise(rows, cols, std::max(1.0, 3.0 / cell_m), 104);
  const Color flat = Shade(light, Eigen::Vector3f::UnitZ(), 1.0f);
  for (int row = 0; row < rows; ++row) {
    const float* north = ground_m.ptr<float>(std::max(row - 1, 0));
    const float* south = ground_m.ptr<float>(std::min(row + 1, rows - 1));
    const float* here = ground_m.ptr<float>(row);
    Color* out = color.ptr<Color>(row);
    for (int col = 0; col < cols; ++col) {
      const float scale = stretch / static_cast<float>(2.0 * cell_m);
      const Eigen::Vector3f normal =
          Eigen::Vector3f(-(here[std::min(col + 1, cols - 1)] - here[std::max(col - 1, 0)]) * scale,
                          -(north[col] - south[col]) * scale, 1.0f)
              .normalized();
      const float lit = sun.at<float>(row, col);
      const float hollow = stretch * (level_m.at<float>(row, col) - smooth_m.at<float>(row, col));
      const float openness = std::clamp(1.0f + 0.035f * hollow, 0.72f, 1.14f);
      Color ground = Times(out[col], Shade(light, normal, lit)) * openness;

      const float depth = depth_m.at<float>(row, col);
      const float water = std::clamp(depth / 0.25f, 0.0f, 1.0f);
      if (water > 0.0f) {
        const float ripple = 1.0f + 0.02f * ripples.at<float>(row, col);
        const Color surface =
            Times(WaterColor(scene, depth), flat) * (ripple * (0.55f + 0.45f * lit));
        ground = Mix(ground * 0.8f, surface, 0.35f * water + 0.65f * water * std::min(1.0f, depth));
      }
      out[col] = ground;
    }
  }
  return color;
}

}  // namespace latticeworld
