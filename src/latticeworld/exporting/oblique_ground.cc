#include "latticeworld/exporting/oblique_ground.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "latticeworld/exporting/ground_colors.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// What the ground shows where a ray meets it.
struct GroundSample {
  float z_m;
  Color color;
};

class GroundSampler {
 public:
  GroundSampler(const ShadedGround& ground, const GridGeometry& geometry)
      : ground_(ground), geometry_(geometry) {}

  void SetLine(float y_m) {
    const float last = geometry_.rows() - 1.001f;
    const float row = std::clamp(static_cast<float>(geometry_.RowOf(y_m)), 0.0f, last);
    const int north = static_cast<int>(row);
    share_ = row - north;
    z_north_ = ground_.surface_m.ptr<float>(north);
    z_south_ = ground_.surface_m.ptr<float>(north + 1);
    color_north_ = ground_.color.ptr<Color>(north);
    color_south_ = ground_.color.ptr<Color>(north + 1);
    water_ = ground_.water.ptr<float>(north);
  }

  // col: continuous, inside the grid.
  float HeightAt(float col) const {
    const int west = static_cast<int>(col);
    const float u = col - west;
    return (z_north_[west] * (1 - u) + z_north_[west + 1] * u) * (1 - share_) +
           (z_south_[west] * (1 - u) + z_south_[west + 1] * u) * share_;
  }
  Color ColorAt(float col) const {
    const int west = static_cast<int>(col);
    const float u = col - west;
    return (color_north_[west] * (1 - u) + color_north_[west + 1] * u) * (1 - share_) +
           (color_south_[west] * (1 - u) + color_south_[west + 1] * u) * share_;
  }
  float WaterAt(float col) const { return water_[static_cast<int>(col)]; }

 private:
  const ShadedGround& ground_;
  const GridGeometry& geometry_;
  float share_ = 0.0f;
  const float* z_north_ = nullptr;
  const float* z_south_ = nullptr;
  const Color* color_north_ = nullptr;
  const Color* color_south_ = nullptr;
  const float* water_ = nullptr;
};

// Soil and rock in layers that follow the ground above.
Color EarthColor(float below_m, float block_m, float wave) {
  const float depth = below_m / block_m;
  if (depth < 0.07f) return FromRgb(92, 70, 50);
  const float layer = std::sin(26.0f * depth + 1.4f * wave) + 0.6f * std::sin(61.0f * depth + wave);
  return FromRgb(142, 116, 90) * (1.0f + 0.07f * layer - 0.25f * depth);
}

// The cut face of the block along the south edge, water included.
void PaintSkirt(const Scene& scene, const ShadedGround& ground, const PictureLight& light,
                const ObliqueCamera& camera, float skirt_m, Canvas* canvas) {
  const GridGeometry& geometry = scene.geometry();
  const float half_m = static_cast<float>(geometry.half_size_m());
  const float distance_m = camera.DistanceOf(-half_m);
  const float scale = camera.PixelsPerMetre(distance_m);
  const int last = geometry.rows() - 1;
  const cv::Mat waves = SmoothNoise(1, canvas->bgr.cols, 90.0 * kSupersample, 105);
  const Color face = Shade(light, -Eigen::Vector3f::UnitY(), 0.6f) + light.ambient * 0.25f;
  const float haze = Haze(scene).At(-half_m);
  for (int x = 0; x < canvas->bgr.cols; ++x) {
    const float x_m = (x - camera.center_x_px()) / scale;
    if (std::abs(x_m) > half_m) continue;
    const int col = geometry.CellAt({x_m, -half_m}).col;
    const float surface_m = ground.surface_m.at<float>(last, col);
    const float bed_m =
        (scene.terrain->ground.height_m()(last, col) - ground.base_m) * ground.exaggeration;
    const int top = static_cast<int>(camera.Project(x_m, distance_m, surface_m).y());
    const int bottom = static_cast<int>(camera.Project(x_m, distance_m, -skirt_m).y());
    for (int y = std::max(0, top); y < std::min(bottom, canvas->bgr.rows); ++y) {
      const float z_m = surface_m - (y - top) / scale;
      Color color = z_m > bed_m ? FromRgb(44, 106, 142)
                                : EarthColor(bed_m - z_m, skirt_m + bed_m, waves.at<float>(0, x));
      color = Mix(Times(color, face), light.fog, haze);
      canvas->bgr.at<cv::Vec3b>(y, x) = ToBytes(color);
      canvas->distance.at<float>(y, x) = distance_m;
    }
  }
}

}  // namespace

Haze::Haze(const Scene& scene)
    : half_size_m_(static_cast<float>(scene.geometry().half_size_m())),
      size_m_(2.0f * half_size_m_),
      visibility_m_(static_cast<float>(std::max(1.0, scene.atmosphere.visibility_m))) {}

float Haze::At(float y_m) const {
  // Through the air of the world itself, the camera stands outside it. However thick the air, it
  // leaves the near half of the world readable: it is drawn as if it lay behind.
  constexpr float kContrast = 3.0f;  // contrast left at the visibility is e^-3
  constexpr float kThickest = 1.0f;  // optical depth drawn at the far edge
  const float through = std::clamp((y_m + half_size_m_) / size_m_, 0.0f, 1.0f);
  const float depth = std::min(kContrast / visibility_m_ * size_m_ * through,
                               kThickest * (0.08f + 0.92f * through * through));
  return 1.0f - std::exp(-depth);
}

void PaintBackdrop(const PictureLight& light, cv::Mat* bgr) {
  // Clouds: several octaves, stretched sideways, thinning out towards the horizon.
  const int rows = bgr->rows, cols = bgr->cols;
  cv::Mat clouds = cv::Mat::zeros(rows / 2, cols, CV_32FC1);
  double wavelength_px = cols / 5.0, strength = 1.0;
  for (std::uint64_t octave = 0; octave < 5; ++octave, wavelength_px /= 2.1, strength *= 0.55) {
    cv::Mat noise = SmoothNoise(std::max(2, rows / 5), cols / 2, wavelength_px / 2.0, 110 + octave);
    cv::resize(noise, noise, clouds.size(), 0, 0, cv::INTER_CUBIC);
    clouds += strength * noise;
  }
  const Color cloud_color =
      Mix(light.sky_low, FromRgb(255, 255, 255), light.is_night ? 0.05f : 0.7f);
  for (int y = 0; y < rows; ++y) {
    const float down = static_cast<float>(y) / rows;
    const Color sky =
        Mix(light.sky_high, light.sky_low, std::min(1.0f, std::pow(2.6f * down, 0.8f)));
    cv::Vec3b* out = bgr->ptr<cv::Vec3b>(y);
    for (int x = 0; x < cols; ++x) {
      if (y >= clouds.rows) {
        out[x] = ToBytes(sky);
        continue;
      }
      const float density = clouds.at<float>(y, x) - 0.35f - 2.2f * down;
      out[x] = ToBytes(
          Mix(sky, cloud_color, std::clamp(0.55f * density, 0.0f, 0.75f) * (1.0f - 2.0f * down)));
    }
  }
  cv::RNG random(108);
  const int stars = static_cast<int>(260.0f * light.stars);
  for (int i = 0; i < stars; ++i) {
    const cv::Point at(random.uniform(0, cols), random.uniform(0, rows / 2));
    const double glow = random.uniform(110.0, 240.0);
    cv::circle(*bgr, at, random.uniform(0, 10) == 0 ? kSupersample : 1,
               cv::Scalar(glow, glow * 0.95, glow * 0.9), cv::FILLED, cv::LINE_AA);
  }
}

// The shade that the block throws on what it stands on.
void PaintBlockShade(const ObliqueCamera& camera, float half_m, float skirt_m, cv::Mat* bgr) {
  const float distance_m = camera.DistanceOf(-half_m);
  const Eigen::Vector2f left = camera.Project(-half_m, distance_m, -skirt_m);
  const Eigen::Vector2f right = camera.Project(half_m, distance_m, -skirt_m);
  const float reach_px = 0.045f * (right.x() - left.x());
  for (int y = std::max(0, static_cast<int>(left.y() - reach_px)); y < bgr->rows; ++y) {
    for (int x = 0; x < bgr->cols; ++x) {
      const float dx = std::max({0.0f, left.x() - x, x - right.x()});
      const float dy = std::abs(y - left.y());
      const float fade = 1.0f - std::min(1.0f, std::hypot(dx, dy) / reach_px);
      if (fade > 0.0f) bgr->at<cv::Vec3b>(y, x) *= 1.0f - 0.42f * fade * fade;
    }
  }
}

void PaintObliqueGround(const Scene& scene, const ShadedGround& ground, const PictureLight& light,
                        const ObliqueCamera& camera, float skirt_m, Canvas* canvas) {
  const GridGeometry& geometry = scene.geometry();
  const float half_m = static_cast<float>(geometry.half_size_m());
  const float cell_m = static_cast<float>(geometry.resolution_m());
  const float last_col = geometry.cols() - 1.001f;
  const int width = canvas->bgr.cols;
  const Haze haze(scene);
  GroundSampler sampler(ground, geometry);
  PaintBlockShade(camera, half_m, skirt_m, &canvas->bgr);
  PaintSkirt(scene, ground, light, camera, skirt_m, canvas);

  // Per picture column: how high it is filled, and where and what the last sample was.
  std::vector<int> filled(static_cast<std::size_t>(width), canvas->bgr.rows);
  std::vector<float> last_y(filled.size(), 0.0f);
  std::vector<Color> last_color(filled.size());
  const float near_m = camera.DistanceOf(-half_m), far_m = camera.DistanceOf(half_m);
  bool first = true;
  for (float distance_m = near_m; distance_m < far_m;) {
    const float y_m = -half_m + (distance_m - near_m);
    const float scale = camera.PixelsPerMetre(distance_m);
    const float fog = haze.At(y_m);
    const Color sky = Mix(light.sky_low, light.sky_high, 0.35f);
    const float mirror = 0.16f + 0.3f * (distance_m - near_m) / (far_m - near_m);
    sampler.SetLine(y_m);
    const int x_first =
        std::max(0, static_cast<int>(std::ceil(camera.center_x_px() - half_m * scale)));
    const int x_last =
        std::min(width - 1, static_cast<int>(std::floor(camera.center_x_px() + half_m * scale)));
    for (int x = x_first; x <= x_last; ++x) {
      const float x_m = (x - camera.center_x_px()) / scale;
      const float col = std::clamp((x_m + half_m) / cell_m - 0.5f, 0.0f, last_col);
      const float y = camera.Project(x_m, distance_m, sampler.HeightAt(col)).y();
      const int top = std::max(0, static_cast<int>(std::ceil(y)));
      if (first) filled[x] = std::min(canvas->bgr.rows, top);
      const float before_y = last_y[x];
      last_y[x] = y;
      if (top >= filled[x] && !first) continue;
      Color color = sampler.ColorAt(col);
      const float water = sampler.WaterAt(col);
      if (water > 0.0f) color = Mix(color, sky, mirror * water);
      color = Mix(color, light.fog, fog);
      // Between two samples in sight the colour runs evenly; past a crest it begins anew.
      const bool runs_on = before_y > y && before_y <= filled[x] + 0.5f && !first;
      for (int row = filled[x] - 1; row >= top; --row) {
        const float share =
            runs_on ? std::clamp((before_y - row) / (before_y - y), 0.0f, 1.0f) : 1.0f;
        canvas->bgr.at<cv::Vec3b>(row, x) =
            ToBytes(runs_on ? Mix(last_color[x], color, share) : color);
        canvas->distance.at<float>(row, x) = distance_m;
      }
      filled[x] = std::min(filled[x], top);
      last_color[x] = color;
    }
    first = false;
    // About one line of the picture on level ground.
    distance_m += std::max(0.05f * cell_m,
                           0.9f * distance_m * distance_m / (camera.focal_px() * camera.eye_z_m()));
  }
}

void PaintPrecipitation(const Scene& scene, cv::Mat* bgr) {
  const Weather weather = scene.atmosphere.weather;
  if (weather != Weather::kRain && weather != Weather::kSnow) return;
  cv::RNG random(109);
  cv::Mat layer = bgr->clone();
  const int count = weather == Weather::kRain ? 900 : 1100;
  const int unit = std::max(1, bgr->cols / 800);
  const int slant = static_cast<int>(std::clamp(scene.atmosphere.wind_mps.x(), -8.0, 8.0));
  for (int i = 0; i < count; ++i) {
    const cv::Point at(random.uniform(0, bgr->cols), random.uniform(0, bgr->rows));
    if (weather == Weather::kRain) {
      const int length = random.uniform(10, 26) * unit;
      cv::line(layer, at, {at.x + slant * length / 16, at.y + length}, cv::Scalar(236, 230, 224),
               unit, cv::LINE_AA);
    } else {
      cv::circle(layer, at, random.uniform(1, 3) * unit, cv::Scalar(255, 255, 255), cv::FILLED,
                 cv::LINE_AA);
    }
  }
  const double strength = weather == Weather::kRain ? 0.28 : 0.7;
  cv::addWeighted(layer, strength, *bgr, 1.0 - strength, 0.0, *bgr);
}

}  // namespace latticeworld
