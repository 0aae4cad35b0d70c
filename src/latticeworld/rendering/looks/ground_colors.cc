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

// Colours the ground of a scene, a cell a pixel: by what it is made of, season, weather and style.
class GroundPainter {
 public:
  explicit GroundPainter(const Scene& scene)
      : scene_(scene),
        terrain_(*scene.terrain),
        season_(ColorsOf(scene.environment.coarse.season)),
        is_dry_(IsDryLand(scene)),
        yards_(YardsAroundHouses(scene)),
        rims_(RoadRims(scene)) {
    const bool desert = scene.environment.coarse.terrain_type == TerrainType::kDesert;
    const bool wild = terrain_.weights.vocabulary == Vocabulary::kWild;
    barren_ = desert ? FromRgb(222, 190, 138) : FromRgb(166, 144, 116);
    soil_ = desert ? Mix(season_.soil, barren_, 0.5f) : season_.soil;
    road_ = wild ? FromRgb(150, 132, 108) : FromRgb(112, 112, 118);
    rim_ = RoadRim(ArtisticStyle::kRealistic, road_);

    const int rows = terrain_.geometry().rows(), cols = terrain_.geometry().cols();
    const double cell_m = terrain_.geometry().resolution_m();
    patches_ = SmoothNoise(rows, cols, std::max(1.0, 38.0 / cell_m), 101);
    tufts_ = SmoothNoise(rows, cols, std::max(1.0, 7.0 / cell_m), 102);
    grain_ = SmoothNoise(rows, cols, std::max(1.0, 1.6 / cell_m), 103);
  }

  cv::Mat Paint() const {
    const GridGeometry& geometry = terrain_.geometry();
    cv::Mat colors(geometry.rows(), geometry.cols(), CV_32FC3);
    for (int row = 0; row < colors.rows; ++row) {
      Color* out = colors.ptr<Color>(row);
      for (int col = 0; col < colors.cols; ++col) out[col] = ColorOf({row, col});
    }
    // Classes change from cell to cell; the land does not.
    cv::GaussianBlur(colors, colors, {}, std::max(0.4, 0.6 / geometry.resolution_m()));
    PaintCrops(scene_, season_.grass, &colors);
    AddWeather(&colors);
    if (scene_.environment.coarse.artistic_style != ArtisticStyle::kRealistic) Stylise(&colors);
    return colors;
  }

 private:
  Color ColorOf(CellIndex cell) const {
    const float patch = patches_.at<float>(cell.row, cell.col);
    const float tuft = tufts_.at<float>(cell.row, cell.col);
    switch (terrain_.surface[cell]) {
      case SurfaceClass::kGrass:
        return Mix(season_.grass, season_.dry_grass, Smoothstep(-1.2f, 1.8f, patch + 0.5f * tuft));
      case SurfaceClass::kForestFloor:
        return season_.forest_floor * (1.0f + 0.06f * patch + 0.05f * tuft);
      case SurfaceClass::kFarmland:
        return soil_ * (1.0f + 0.03f * patch + 0.02f * tuft);
      case SurfaceClass::kBarren:
        return barren_ * (1.0f + 0.05f * patch + 0.03f * tuft);
      case SurfaceClass::kRoad:
        return Mix(road_ * (1.0f + 0.02f * tuft), rim_, rims_.at<float>(cell.row, cell.col));
      case SurfaceClass::kBuilding:
        return Mix(GardenAt(cell, patch), FromRgb(206, 192, 162),
                   0.9f * yards_.at<float>(cell.row, cell.col)) *
               (1.0f + 0.03f * tuft);
      case SurfaceClass::kRock:
        return FromRgb(134, 128, 120) * (1.0f + 0.07f * patch + 0.08f * tuft);
      case SurfaceClass::kSnow:
        return FromRgb(240, 244, 250) * (1.0f + 0.012f * patch);
      case SurfaceClass::kWaterBed:
        return FromRgb(150, 140, 108);
    }
    return {};
  }

  // Returns the colour of ground between the houses of a settlement.
  Color GardenAt(CellIndex cell, float patch) const {
    if (is_dry_) return Mix(barren_, season_.grass, 0.25f);
    const WorldPoint point = terrain_.geometry().CenterOf(cell);
    return GardenColor(season_.grass, point.x_m, point.y_m, patch);
  }

  // Grain, wet ground in rain, and fallen snow where it is level enough to stay.
  void AddWeather(cv::Mat* colors) const {
    const auto snow =
        static_cast<float>(std::clamp(scene_.atmosphere.snow_depth_m / 0.12, 0.0, 1.0));
    const float wet = scene_.atmosphere.weather == Weather::kRain ? 0.86f : 1.0f;
    for (int row = 0; row < colors->rows; ++row) {
      Color* out = colors->ptr<Color>(row);
      for (int col = 0; col < colors->cols; ++col) {
        out[col] *= (1.0f + 0.014f * grain_.at<float>(row, col)) * wet;
        if (snow == 0.0f) continue;
        const float cover =
            snow * Smoothstep(-1.6f, 0.2f,
                              0.7f * tufts_.at<float>(row, col) +
                                  0.5f * patches_.at<float>(row, col) + 1.4f * snow);
        const bool swept = terrain_.surface(row, col) == SurfaceClass::kRoad;
        out[col] = Mix(out[col], FromRgb(238, 242, 248), cover * (swept ? 0.5f : 0.92f));
      }
    }
  }

  void Stylise(cv::Mat* colors) const {
    const ArtisticStyle style = scene_.environment.coarse.artistic_style;
    const Color rim = RoadRim(style, road_);
    for (int row = 0; row < colors->rows; ++row) {
      Color* out = colors->ptr<Color>(row);
      for (int col = 0; col < colors->cols; ++col) {
        out[col] = Mix(InStyle(style, out[col]), rim, rims_.at<float>(row, col));
      }
    }
  }

  const Scene& scene_;
  const Terrain& terrain_;
  SeasonColors season_;
  bool is_dry_;
  cv::Mat yards_, rims_;  // in [0, 1]: around houses, of roads
  Color barren_, soil_, road_, rim_;
  // Noise of normal deviates: patches of tens of metres, tufts of a few, grain of one cell.
  cv::Mat patches_, tufts_, grain_;
};

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

GroundMaterials MaterialsOf(const Scene& scene) {
  return {GroundPainter(scene).Paint(), WaterDepth(scene)};
}

}  // namespace latticeworld
