#include "latticeworld/rendering/looks/ground_colors.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "latticeworld/rendering/looks/crop_ground.h"
#include "latticeworld/rendering/looks/picture_style.h"
#include "latticeworld/rendering/looks/village_ground.h"
#include "latticeworld/rendering/ray/picture_light.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

struct SeasonColors {
  Color grass, dry_grass, forest_floor, soil;  // soil: of fields, between their plants
};

SeasonColors ColorsOf(Season season) {
  switch (season) {
    case Season::kSpring:
      return {FromRgb(126, 168, 78), FromRgb(160, 182, 96), FromRgb(92, 122, 62),
              FromRgb(136, 112, 82)};
    case Season::kSummer:
      return {FromRgb(118, 150, 74), FromRgb(158, 164, 92), FromRgb(78, 104, 54),
              FromRgb(150, 126, 90)};
    case Season::kAutumn:
      return {FromRgb(158, 148, 80), FromRgb(184, 158, 92), FromRgb(126, 104, 66),
              FromRgb(134, 108, 78)};
    case Season::kWinter:
      return {FromRgb(150, 148, 112), FromRgb(166, 156, 122), FromRgb(112, 100, 78),
              FromRgb(126, 106, 84)};
  }
  return {};
}

float Smoothstep(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

}  // namespace

cv::Mat SmoothNoise(int rows, int cols, double wavelength_cells, std::uint64_t seed) {
  cv::RNG random(seed);
  const int coarse_rows = static_cast<int>(std::ceil(rows / wavelength_cells)) + 2;
  const int coarse_cols = static_cast<int>(std::ceil(cols / wavelength_cells)) + 2;
  cv::Mat coarse(coarse_rows, coarse_cols, CV_32FC1);
  random.fill(coarse, cv::RNG::NORMAL, 0.0, 1.0);
  if (wavelength_cells <= 1.0) return coarse(cv::Rect(0, 0, cols, rows)).clone();
  cv::Mat smooth;
  cv::resize(coarse, smooth, {}, wavelength_cells, wavelength_cells, cv::INTER_CUBIC);
  return smooth(cv::Rect(0, 0, cols, rows)).clone();
}

namespace {

cv::Mat GroundColors(const Scene& scene) {
  const Terrain& terrain = *scene.terrain;
  const GridGeometry& geometry = terrain.geometry();
  const CoarseAttributes& coarse = scene.environment.coarse;
  const SeasonColors season = ColorsOf(coarse.season);
  const bool desert = coarse.terrain_type == TerrainType::kDesert;
  const bool dry = IsDryLand(scene);
  const bool wild = terrain.weights.vocabulary == Vocabulary::kWild;
  const Color barren = desert ? FromRgb(222, 190, 138) : FromRgb(166, 144, 116);
  const Color soil = desert ? Mix(season.soil, barren, 0.5f) : season.soil;
  const Color road = wild ? FromRgb(150, 132, 108) : FromRgb(112, 112, 118);

  const ArtisticStyle style = coarse.artistic_style;
  const Color rim = RoadRim(ArtisticStyle::kRealistic, road);

  // Patches of tens of metres, tufts of a few, grain of one cell.
  const int rows = geometry.rows(), cols = geometry.cols();
  const double cell_m = geometry.resolution_m();
  const cv::Mat patches = SmoothNoise(rows, cols, std::max(1.0, 38.0 / cell_m), 101);
  const cv::Mat tufts = SmoothNoise(rows, cols, std::max(1.0, 7.0 / cell_m), 102);
  const cv::Mat yards = YardsAroundHouses(scene);
  const cv::Mat rims = RoadRims(scene);
  const cv::Mat grain = SmoothNoise(rows, cols, std::max(1.0, 1.6 / cell_m), 103);

  cv::Mat colors(rows, cols, CV_32FC3);
  for (int row = 0; row < rows; ++row) {
    Color* out = colors.ptr<Color>(row);
    for (int col = 0; col < cols; ++col) {
      const float patch = patches.at<float>(row, col), tuft = tufts.at<float>(row, col);
      const WorldPoint point = geometry.CenterOf({row, col});
      switch (terrain.surface(row, col)) {
        case SurfaceClass::kGrass:
          out[col] =
              Mix(season.grass, season.dry_grass, Smoothstep(-1.2f, 1.8f, patch + 0.5f * tuft));
          break;
        case SurfaceClass::kForestFloor:
          out[col] = season.forest_floor * (1.0f + 0.06f * patch + 0.05f * tuft);
          break;
        case SurfaceClass::kFarmland:
          out[col] = soil * (1.0f + 0.03f * patch + 0.02f * tuft);
          break;
        case SurfaceClass::kBarren:
          out[col] = barren * (1.0f + 0.05f * patch + 0.03f * tuft);
          break;
        case SurfaceClass::kRoad:
          out[col] = Mix(road * (1.0f + 0.02f * tuft), rim, rims.at<float>(row, col));
          break;
        case SurfaceClass::kBuilding:
          out[col] = Mix(dry ? Mix(barren, season.grass, 0.25f)
                             : GardenColor(season.grass, point.x_m, point.y_m, patch),
                         FromRgb(206, 192, 162), 0.9f * yards.at<float>(row, col)) *
                     (1.0f + 0.03f * tuft);
          break;
        case SurfaceClass::kRock:
          out[col] = FromRgb(134, 128, 120) * (1.0f + 0.07f * patch + 0.08f * tuft);
          break;
        case SurfaceClass::kSnow:
          out[col] = FromRgb(240, 244, 250) * (1.0f + 0.012f * patch);
          break;
        case SurfaceClass::kWaterBed:
          out[col] = FromRgb(150, 140, 108);
          break;
      }
    }
  }
  // Classes change from cell to cell; the land does not.
  cv::GaussianBlur(colors, colors, {}, std::max(0.4, 0.6 / cell_m));
  PaintCrops(scene, season.grass, &colors);

  // Grain, wet ground in rain, and fallen snow where it is level enough to stay.
  const float snow = static_cast<float>(std::clamp(scene.atmosphere.snow_depth_m / 0.12, 0.0, 1.0));
  const float wet = scene.atmosphere.weather == Weather::kRain ? 0.86f : 1.0f;
  for (int row = 0; row < rows; ++row) {
    Color* out = colors.ptr<Color>(row);
    for (int col = 0; col < cols; ++col) {
      out[col] *= (1.0f + 0.014f * grain.at<float>(row, col)) * wet;
      if (snow == 0.0f) continue;
      const float cover = snow * Smoothstep(-1.6f, 0.2f,
                                            0.7f * tufts.at<float>(row, col) +
                                                0.5f * patches.at<float>(row, col) + 1.4f * snow);
      const bool swept = terrain.surface(row, col) == SurfaceClass::kRoad;
      out[col] = Mix(out[col], FromRgb(238, 242, 248), cover * (swept ? 0.5f : 0.92f));
    }
  }
  if (style == ArtisticStyle::kRealistic) return colors;
  const Color bright_rim = RoadRim(style, road);
  for (int row = 0; row < rows; ++row) {
    Color* out = colors.ptr<Color>(row);
    for (int col = 0; col < cols; ++col)
      out[col] = Mix(InStyle(style, out[col]), bright_rim, rims.at<float>(row, col));
  }
  return colors;
}

cv::Mat WaterDepth(const Scene& scene) {
  const Grid<float>& height_m = scene.terrain->ground.height_m();
  const Grid<float>& level_m = scene.terrain->water_level_m;
  cv::Mat depth(height_m.rows(), height_m.cols(), CV_32FC1);
  for (int row = 0; row < height_m.rows(); ++row) {
    for (int col = 0; col < height_m.cols(); ++col) {
      const float level = level_m(row, col);
      depth.at<float>(row, col) = level > height_m(row, col) ? level - height_m(row, col) : 0.0f;
    }
  }
  return depth;
}

}  // namespace

GroundMaterials MaterialsOf(const Scene& scene) { return {GroundColors(scene), WaterDepth(scene)}; }

}  // namespace latticeworld
