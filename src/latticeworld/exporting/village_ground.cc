#include "latticeworld/exporting/village_ground.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr double kPlotLength_m = 21.0;
constexpr double kPlotWidth_m = 15.0;
constexpr float kYard_m = 2.6f;  // around a house
constexpr float kRim_m = 1.1f;   // of a road

}  // namespace

Color GardenColor(const Color& grass, double x_m, double y_m, float waviness) {
  const double v = y_m / kPlotWidth_m + 0.06 * waviness;
  const double row = std::floor(v);
  const double u = x_m / kPlotLength_m + HashToUnit(61, static_cast<int>(row), 0) + 0.05 * waviness;
  const double col = std::floor(u);
  const double kind = HashToUnit(62, static_cast<int>(row), static_cast<int>(col));
  const Color garden = Mix(grass, FromRgb(104, 150, 70), 0.45f);
  Color plot;
  if (kind < 0.45) {
    plot = garden * (0.97f + 0.2f * static_cast<float>(kind));
  } else if (kind < 0.7) {  // beds
    const bool bed = std::sin(y_m * (2.0 * M_PI / 2.6)) > 0.1;
    plot = bed ? FromRgb(130, 104, 76) : garden * 0.92f;
  } else {
    plot = Mix(garden, FromRgb(176, 154, 118), 0.62f);
  }
  const double hedge_m = std::min(std::min(u - col, col + 1.0 - u) * kPlotLength_m,
                                  std::min(v - row, row + 1.0 - v) * kPlotWidth_m);
  return Mix(plot, FromRgb(74, 104, 54),
             0.7f * static_cast<float>(std::clamp(1.2 - hedge_m, 0.0, 1.0)));
}

cv::Mat YardsAroundHouses(const Scene& scene) {
  constexpr int kFraction = 4;  // bits of OpenCV's fixed-point coordinates
  const GridGeometry& geometry = scene.geometry();
  cv::Mat yards = cv::Mat::zeros(geometry.rows(), geometry.cols(), CV_32FC1);
  bool any = false;
  for (const Asset& asset : scene.assets) {
    if (asset.kind != AssetKind::kBuilding) continue;
    any = true;
    const Eigen::Vector2f along(std::cos(asset.yaw_rad), std::sin(asset.yaw_rad));
    const Eigen::Vector2f across(-along.y(), along.x());
    std::vector<cv::Point> corners;
    for (const auto& [l, w] : {std::pair<int, int>{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      const Eigen::Vector2f at = Eigen::Vector2f(asset.x_m, asset.y_m) +
                                 along * (l * (asset.half_length_m + kYard_m)) +
                                 across * (w * (asset.half_width_m + kYard_m));
      corners.emplace_back(
          static_cast<int>(std::lround(geometry.ColOf(at.x()) * (1 << kFraction))),
          static_cast<int>(std::lround(geometry.RowOf(at.y()) * (1 << kFraction))));
    }
    cv::fillConvexPoly(yards, corners, cv::Scalar(1.0), cv::LINE_8, kFraction);
  }
  if (any) cv::GaussianBlur(yards, yards, {}, std::max(0.5, 0.8 / geometry.resolution_m()));
  return yards;
}

cv::Mat RoadRims(const Scene& scene) {
  const Grid<SurfaceClass>& surface = scene.terrain->surface;
  const float cell_m = static_cast<float>(scene.geometry().resolution_m());
  cv::Mat road(surface.rows(), surface.cols(), CV_8UC1);
  for (int row = 0; row < road.rows; ++row)
    for (int col = 0; col < road.cols; ++col)
      road.at<unsigned char>(row, col) = surface(row, col) == SurfaceClass::kRoad ? 1 : 0;
  cv::Mat inside;
  cv::distanceTransform(road, inside, cv::DIST_L2, cv::DIST_MASK_3);
  // The distance is 1 at the outermost cell; coarse worlds have no cells to spare for a rim.
  cv::Mat rims(road.size(), CV_32FC1, cv::Scalar(0.0));
  if (cell_m > kRim_m) return rims;
  for (int row = 0; row < road.rows; ++row) {
    for (int col = 0; col < road.cols; ++col) {
      const float in = inside.at<float>(row, col);
      if (in > 0.0f) rims.at<float>(row, col) = std::clamp(kRim_m / cell_m + 1.0f - in, 0.0f, 1.0f);
    }
  }
  return rims;
}

}  // namespace latticeworld
