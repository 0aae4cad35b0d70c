#include "latticeworld/rendering/ray/weathering.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/rendering/ray/ray_noise.h"
#include "latticeworld/scene/weather/atmosphere.h"

namespace latticeworld {
namespace {

const Light kSnow(.84f, .88f, .94f);
const Light kSand(.72f, .51f, .26f);
constexpr float kDeepSnow_m = 0.1f;   // from which on it covers all
constexpr float kWetDarkens = 0.45f;  // of bare ground's light that wet ground keeps to itself
constexpr float kSandCovers = 0.7f;
constexpr float kIce = 0.8f;

float Smoothstep(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

}  // namespace

Weathering::Weathering(const Atmosphere& atmosphere, Season season)
    : snow_(static_cast<float>(std::clamp(atmosphere.snow_depth_m / kDeepSnow_m, 0.0, 1.0))),
      wet_(static_cast<float>(atmosphere.ground_wetness)),
      sand_(static_cast<float>(atmosphere.blown_sand)),
      ice_(season == Season::kWinter && atmosphere.snow_depth_m > 0.0 ? kIce : 0.0f) {}

void Weathering::Apply(const RayHit& hit, const Eigen::Vector3f& point_m, SurfaceLook* look) const {
  const bool is_ground = hit.target == RayTarget::kGround;
  const float up = std::clamp(2.2f * (hit.normal.z() - 0.25f), 0.0f, 1.0f);
  if (is_ground && wet_ > 0.0f) look->albedo *= 1.0f - kWetDarkens * wet_;
  if (sand_ > 0.0f) look->albedo = Blend(look->albedo, kSand, kSandCovers * sand_ * up);
  if (snow_ <= 0.0f) return;
  float cover = snow_ * up;
  if (is_ground && snow_ < 1.0f) {
    // The first snow stays in patches.
    const float patch = DetailNoise(point_m.x(), point_m.y(), 7.0f, 4, 0.6f, 0.05f, 461);
    cover *= Smoothstep(-1.1f, 0.3f, patch + 1.4f * snow_);
  }
  look->albedo = Blend(look->albedo, kSnow, (is_ground ? 0.92f : 0.8f) * cover);
}

}  // namespace latticeworld
