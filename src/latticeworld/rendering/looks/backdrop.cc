#include "latticeworld/rendering/looks/backdrop.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "latticeworld/common/random.h"
#include "latticeworld/rendering/looks/ground_colors.h"
#include "latticeworld/rendering/views/painting.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {

namespace {

// Returns whether single clouds stand before the sky.
bool HasClouds(Weather weather) {
  return weather == Weather::kSunny || weather == Weather::kCloudy;
}

// The same for one land, whatever the hour.
std::uint64_t CloudSeed(const Scene& scene) {
  const HeightField& ground = scene.terrain->ground;
  return static_cast<std::uint64_t>(
      1e6 * HashToUnit(110, std::lround(1000.0 * ground.HeightAt({0.0, 0.0})),
                       std::lround(1000.0 * ground.min_m())));
}

}  // namespace

void PaintBackdrop(const Scene& scene, const PictureSky& sky, cv::Mat* bgr) {
  // Clouds: several octaves, stretched sideways, thinning out towards the horizon.
  const int rows = bgr->rows, cols = bgr->cols;
  cv::Mat clouds = cv::Mat::zeros(rows / 2, cols, CV_32FC1);
  double wavelength_px = cols / 5.0, strength = 1.0;
  const std::uint64_t seed = CloudSeed(scene);
  const float cover = HasClouds(scene.atmosphere.weather) ? 1.0f : 0.0f;
  for (std::uint64_t octave = 0; octave < 5; ++octave, wavelength_px /= 2.1, strength *= 0.55) {
    cv::Mat noise =
        SmoothNoise(std::max(2, rows / 5), cols / 2, wavelength_px / 2.0, seed + octave);
    cv::resize(noise, noise, clouds.size(), 0, 0, cv::INTER_CUBIC);
    clouds += strength * noise;
  }
  const Color cloud_color = Mix(sky.low, FromRgb(255, 255, 255), sky.is_night ? 0.05f : 0.7f);
  for (int y = 0; y < rows; ++y) {
    const float down = static_cast<float>(y) / rows;
    const Color clear = Mix(sky.high, sky.low, std::min(1.0f, std::pow(2.6f * down, 0.8f)));
    cv::Vec3b* out = bgr->ptr<cv::Vec3b>(y);
    for (int x = 0; x < cols; ++x) {
      if (y >= clouds.rows) {
        out[x] = ToBytes(clear);
        continue;
      }
      const float density = clouds.at<float>(y, x) - 0.35f - 2.2f * down;
      out[x] =
          ToBytes(Mix(clear, cloud_color,
                      cover * std::clamp(0.55f * density, 0.0f, 0.75f) * (1.0f - 2.0f * down)));
    }
  }
  cv::RNG random(108);
  const int stars = static_cast<int>(260.0f * sky.stars);
  for (int i = 0; i < stars; ++i) {
    const cv::Point at(random.uniform(0, cols), random.uniform(0, rows / 2));
    const double glow = random.uniform(110.0, 240.0);
    cv::circle(*bgr, at, random.uniform(0, 10) == 0 ? kSupersample : 1,
               cv::Scalar(glow, glow * 0.95, glow * 0.9), cv::FILLED, cv::LINE_AA);
  }
}

void PaintBlockShade(const Eigen::Vector2f& left_px, const Eigen::Vector2f& right_px,
                     cv::Mat* bgr) {
  const float reach_px = 0.045f * (right_px.x() - left_px.x());
  for (int y = std::max(0, static_cast<int>(left_px.y() - reach_px)); y < bgr->rows; ++y) {
    for (int x = 0; x < bgr->cols; ++x) {
      const float dx = std::max({0.0f, left_px.x() - x, x - right_px.x()});
      const float dy = std::abs(y - left_px.y());
      const float fade = 1.0f - std::min(1.0f, std::hypot(dx, dy) / reach_px);
      if (fade > 0.0f) bgr->at<cv::Vec3b>(y, x) *= 1.0f - 0.42f * fade * fade;
    }
  }
}

void PaintPrecipitation(const Scene& scene, cv::Mat* bgr) {
  const Weather weather = scene.atmosphere.weather;
  if (weather != Weather::kRain && weather != Weather::kSnow) return;
  cv::RNG random(109);
  cv::Mat layer = bgr->clone();
  // Small pictures show less air.
  const double share = std::clamp(bgr->cols / 1600.0, 0.3, 1.0);
  const int count = static_cast<int>(share * (weather == Weather::kRain ? 900 : 1100));
  const int unit = std::max(1, bgr->cols / 800);
  const int largest_flake = bgr->cols < 1000 ? 1 : 3;
  const int slant = static_cast<int>(std::clamp(scene.atmosphere.wind_mps.x(), -8.0, 8.0));
  for (int i = 0; i < count; ++i) {
    const cv::Point at(random.uniform(0, bgr->cols), random.uniform(0, bgr->rows));
    if (weather == Weather::kRain) {
      const int length = std::max(2, static_cast<int>(random.uniform(0.006, 0.016) * bgr->rows));
      cv::line(layer, at, {at.x + slant * length / 16, at.y + length}, cv::Scalar(236, 230, 224),
               unit, cv::LINE_AA);
    } else {
      cv::circle(layer, at, random.uniform(1, largest_flake + 1) * unit, cv::Scalar(255, 255, 255),
                 cv::FILLED, cv::LINE_AA);
    }
  }
  const double strength = weather == Weather::kRain ? 0.28 : 0.7;
  cv::addWeighted(layer, strength, *bgr, 1.0 - strength, 0.0, *bgr);
}

}  // namespace latticeworld
