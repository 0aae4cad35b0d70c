#include "latticeworld/rendering/ray/precipitation.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/rendering/ray/ray_film.h"
#include "latticeworld/rendering/ray/ray_noise.h"

namespace latticeworld {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// What falls.
struct Fall {
  double speed_mps = 0.0;
  double size_m = 0.0;      // across
  double exposure_s = 0.0;  // how long a way is seen of it
  double number = 0.0;      // within sight
  float cover = 0.0f;       // of what is behind, at the size of a pixel or more
};

// Raindrops fall at about 7 m/s, flakes at 1 (Gunn and Kinzer 1949, Langleben 1954). How many are
// drawn is fitted by eye.
Fall FallIn(const Atmosphere& atmosphere) {
  if (atmosphere.snowfall_mmph > 0.05) {
    return {1.0, 0.006, 0.01, 500.0 * std::sqrt(std::min(atmosphere.snowfall_mmph, 10.0)), 0.75f};
  }
  if (atmosphere.rain_mmph > 0.05) {
    return {7.0, 0.002, 0.012, 160.0 * std::sqrt(std::min(atmosphere.rain_mmph, 60.0)), 0.35f};
  }
  return {};
}

constexpr double kNearest_m = 0.35, kFarthest_m = 8.0;
constexpr double kBlink_s = 0.001;  // moments nearer to each other look alike

void Cover(const Vector2d& at_px, float share, const Light& color, const CameraModel& model,
           std::vector<std::uint8_t>* rgb) {
  const int u = static_cast<int>(std::lround(at_px.x()));
  const int v = static_cast<int>(std::lround(at_px.y()));
  if (u < 0 || v < 0 || u >= model.width || v >= model.height) return;
  std::uint8_t* pixel = &(*rgb)[3 * (static_cast<std::size_t>(v) * model.width + u)];
  for (int channel = 0; channel < 3; ++channel) {
    const float value = pixel[channel] + share * (255.0f * color[channel] - pixel[channel]);
    pixel[channel] = static_cast<std::uint8_t>(std::clamp(value, 0.0f, 255.0f));
  }
}

}  // namespace

void DrawPrecipitation(const SensedWorld& world, const CameraModel& model, const RaySky& sky,
                       const Eigen::Isometry3d& map_from_optical, std::vector<std::uint8_t>* rgb) {
  const Fall fall = FallIn(world.atmosphere);
  if (fall.number <= 0.0) return;
  const Vector3d velocity_mps = world.atmosphere.wind_mps - fall.speed_mps * Vector3d::UnitZ();
  const Vector3d way_m = map_from_optical.linear().transpose() * velocity_mps * fall.exposure_s;
  // They shine by the sky around.
  const Light color = Developed(1.15f * sky.Air(Eigen::Vector3f::UnitX()), sky.exposure());
  const auto moment = static_cast<std::uint32_t>(std::llround(world.time_s / kBlink_s));
  const auto count = static_cast<std::uint32_t>(fall.number);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto draw = [&](std::uint32_t which) {
      return static_cast<double>(UnitHash(moment, i, 471u + which));
    };
    // Evenly in the view's volume: the deeper the more.
    const double depth_m = kNearest_m + (kFarthest_m - kNearest_m) * std::cbrt(draw(0));
    const Vector3d at_m =
        depth_m * Vector3d((draw(1) * model.width - model.cx_px) / model.fx_px,
                           (draw(2) * model.height - model.cy_px) / model.fy_px, 1.0);
    const auto begin_px = Project(model, at_m), end_px = Project(model, at_m + way_m);
    if (!begin_px || !end_px) continue;
    const double width_px = fall.size_m * model.fx_px / depth_m;
    const Vector2d along_px = *end_px - *begin_px;
    const int steps = std::clamp(static_cast<int>(along_px.cwiseAbs().maxCoeff()), 0, 200) + 1;
    const float share = fall.cover * static_cast<float>(std::min(1.0, width_px));
    const int half = std::min(2, static_cast<int>(0.5 * width_px));
    for (int step = 0; step < steps; ++step) {
      const Vector2d at_px = *begin_px + along_px * (static_cast<double>(step) / steps);
      for (int dx = -half; dx <= half; ++dx) {
        for (int dy = -half; dy <= half; ++dy) {
          if (dx * dx + dy * dy > half * half + 1) continue;
          Cover(at_px + Vector2d(dx, dy), share, color, model, rgb);
        }
      }
    }
  }
}

}  // namespace latticeworld
