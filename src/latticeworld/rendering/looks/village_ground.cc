#include "latticeworld/rendering/looks/village_ground.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr double kLawn_m = 13.0;  // width of a patch of garden
constexpr double kBedRow_m = 2.4;
constexpr double kBedShare = 0.16;     // of the patches
constexpr double kYard_m = 1.3;        // around a house
constexpr double kWorkYard_m = 3.5;    // around what is wide: barns, blocks
constexpr double kWideFrom_m = 7.5;    // half the frontage
constexpr double kPath_m = 1.4;        // half the width of the way to a door
constexpr double kPathReach_m = 14.0;  // to the street
constexpr float kRim_m = 1.1f;         // of a road

// The nearest of points that are scattered one to a square of the plane: patches with straight
// borders that no grid shows in.
struct Patch {
  int row = 0, col = 0;
};
Patch PatchAt(double x_m, double y_m) {
  const double u = x_m / kLawn_m, v = y_m / kLawn_m;
  const int col = static_cast<int>(std::floor(u)), row = static_cast<int>(std::floor(v));
  Patch nearest;
  double least = INFINITY;
  for (int r = row - 1; r <= row + 1; ++r) {
    for (int c = col - 1; c <= col + 1; ++c) {
      const double du = c + 0.15 + 0.7 * HashToUnit(61, r, c) - u;
      const double dv = r + 0.15 + 0.7 * HashToUnit(62, r, c) - v;
      if (du * du + dv * dv >= least) continue;
      least = du * du + dv * dv;
      nearest = {r, c};
    }
  }
  return nearest;
}

// Fills a rectangle in a building's own axes: from `back` to `front` along yaw, `half` to each
// side.
void FillBeside(const Asset& building, const GridGeometry& geometry, double back_m, double front_m,
                double half_m, cv::Mat* mask) {
  constexpr int kFraction = 4;  // bits of OpenCV's fixed-point coordinates
  const double cosine = std::cos(building.yaw_rad), sine = std::sin(building.yaw_rad);
  std::vector<cv::Point> corners;
  const double corner_m[4][2] = {
      {back_m, -half_m}, {front_m, -half_m}, {front_m, half_m}, {back_m, half_m}};
  for (const auto& [along_m, left_m] : corner_m) {
    const double x_m = building.x_m + cosine * along_m - sine * left_m;
    const double y_m = building.y_m + sine * along_m + cosine * left_m;
    corners.emplace_back(static_cast<int>(std::lround(geometry.ColOf(x_m) * (1 << kFraction))),
                         static_cast<int>(std::lround(geometry.RowOf(y_m) * (1 << kFraction))));
  }
  cv::fillConvexPoly(*mask, corners, cv::Scalar(1.0), cv::LINE_8, kFraction);
}

// How far the street is ahead of a building's front [m], 0: none within reach.
double ToStreet_m(const Scene& scene, const Asset& building) {
  for (double ahead_m = 1.0; ahead_m <= kPathReach_m; ahead_m += 0.5) {
    const double along_m = building.half_length_m + ahead_m;
    const WorldPoint point = {building.x_m + std::cos(building.yaw_rad) * along_m,
                              building.y_m + std::sin(building.yaw_rad) * along_m};
    if (!scene.geometry().Contains(point)) return 0.0;
    if (scene.terrain->SurfaceAt(point) == SurfaceClass::kRoad) return ahead_m;
  }
  return 0.0;
}

}  // namespace

bool IsDryLand(const Scene& scene) {
  if (scene.environment.coarse.terrain_type == TerrainType::kDesert) return true;
  std::size_t barren = 0, green = 0;
  for (const SurfaceClass surface : scene.terrain->surface) {
    barren += surface == SurfaceClass::kBarren;
    green += surface == SurfaceClass::kGrass || surface == SurfaceClass::kForestFloor ||
             surface == SurfaceClass::kFarmland;
  }
  return barren > green;
}

Color GardenColor(const Color& grass, double x_m, double y_m, float waviness) {
  const Patch patch = PatchAt(x_m + 0.8 * waviness, y_m - 0.8 * waviness);
  const double kind = HashToUnit(63, patch.row, patch.col);
  const Color lawn = Mix(grass, FromRgb(104, 150, 70), 0.45f);
  if (kind >= kBedShare) return lawn * (0.96f + 0.10f * static_cast<float>(kind));
  const double turn_rad = M_PI * HashToUnit(64, patch.row, patch.col);
  const double across_m = x_m * std::cos(turn_rad) + y_m * std::sin(turn_rad);
  const bool bed = std::sin(across_m * (2.0 * M_PI / kBedRow_m)) > 0.1;
  return bed ? Mix(lawn, FromRgb(130, 104, 76), 0.7f) : lawn * 0.95f;
}

cv::Mat YardsAroundHouses(const Scene& scene) {
  const GridGeometry& geometry = scene.geometry();
  cv::Mat yards = cv::Mat::zeros(geometry.rows(), geometry.cols(), CV_32FC1);
  bool any = false;
  for (const Asset& asset : scene.assets) {
    if (!scene.catalogue->models()[asset.model].is_house()) continue;
    any = true;
    const double yard_m = asset.half_width_m >= kWideFrom_m ? kWorkYard_m : kYard_m;
    FillBeside(asset, geometry, -asset.half_length_m - yard_m, asset.half_length_m + yard_m,
               asset.half_width_m + yard_m, &yards);
    if (const double street_m = ToStreet_m(scene, asset); street_m > 0.0) {
      FillBeside(asset, geometry, 0.0, asset.half_length_m + street_m, kPath_m, &yards);
    }
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
