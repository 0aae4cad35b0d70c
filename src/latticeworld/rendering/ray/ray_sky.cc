#include "latticeworld/rendering/ray/ray_sky.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "latticeworld/rendering/ray/ray_noise.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

using Eigen::Vector3f;

constexpr float kDegree = static_cast<float>(M_PI) / 180.0f;
constexpr float kSkyScale =
    1.4f;  // of the keys below, so that shadows are not black beside the sun

// A clear sky by the sun's height.
struct SkyKey {
  float sun_deg;
  Light zenith, horizon, glow;  // glow: around the sun, along the horizon
  float exposure;
};
const std::array<SkyKey, 6>& ClearSkies() {
  static const std::array<SkyKey, 6> kKeys = {{
      {-14.0f, {.010f, .016f, .042f}, {.026f, .038f, .072f}, {.0f, .0f, .0f}, 2.0f},
      {-5.0f, {.030f, .045f, .120f}, {.16f, .12f, .16f}, {.25f, .09f, .03f}, 1.6f},
      {2.0f, {.09f, .15f, .34f}, {.46f, .37f, .40f}, {.95f, .42f, .12f}, 1.35f},
      {9.0f, {.12f, .24f, .52f}, {.62f, .62f, .64f}, {.60f, .38f, .16f}, 1.15f},
      {25.0f, {.12f, .27f, .60f}, {.50f, .67f, .88f}, {.30f, .25f, .16f}, 1.0f},
      {60.0f, {.10f, .25f, .60f}, {.46f, .65f, .88f}, {.22f, .20f, .15f}, 0.95f},
  }};
  return kKeys;
}

SkyKey ClearSkyAt(float sun_deg) {
  const auto& keys = ClearSkies();
  if (sun_deg <= keys.front().sun_deg) return keys.front();
  for (std::size_t i = 1; i < keys.size(); ++i) {
    const SkyKey &low = keys[i - 1], &high = keys[i];
    if (sun_deg > high.sun_deg) continue;
    const float share = (sun_deg - low.sun_deg) / (high.sun_deg - low.sun_deg);
    return {sun_deg, Blend(low.zenith, high.zenith, share), Blend(low.horizon, high.horizon, share),
            Blend(low.glow, high.glow, share),
            low.exposure * (1.0f - share) + high.exposure * share};
  }
  return keys.back();
}

// What the air lets through of the sun: redder the lower it stands (air mass of Kasten and Young
// 1989).
Light SunThroughAir(float sun_deg) {
  if (sun_deg <= -1.0f) return Light::Zero();
  const float height_deg = std::max(0.5f, sun_deg);
  const float mass = 1.0f / (std::sin(height_deg * kDegree) +
                             0.50572f * std::pow(height_deg + 6.07995f, -1.6364f));
  const Light depth = Light(.055f, .105f, .20f) * mass;
  const float fade = std::clamp(sun_deg + 1.0f, 0.0f, 1.0f);
  return (-depth).exp() * Light(1.06f, 1.10f, 1.17f) * (2.0f * fade);
}

struct WeatherLook {
  float overcast, cover;
  Light tint;   // of the clouded sky and the air
  float light;  // of the clouded sky, of that of a clear one
};
WeatherLook LookOf(Weather weather) {
  switch (weather) {
    case Weather::kSunny:
      return {0.0f, 0.34f, {1.0f, 1.0f, 1.0f}, 1.0f};
    case Weather::kCloudy:
      return {0.55f, 0.78f, {.97f, .99f, 1.03f}, 1.0f};
    case Weather::kRain:
      return {0.95f, 0.0f, {.92f, .98f, 1.06f}, 0.75f};
    case Weather::kSnow:
      return {0.95f, 0.0f, {.98f, 1.0f, 1.03f}, 0.95f};
    case Weather::kFog:
      return {0.97f, 0.0f, {1.0f, 1.0f, 1.0f}, 0.85f};
    case Weather::kSandstorm:
      return {0.96f, 0.0f, {1.22f, .92f, .56f}, 0.78f};
  }
  return {};
}

}  // namespace

float ToLinear(float srgb) {
  return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

float FromLinear(float linear) {
  if (linear <= 0.0f) return 0.0f;
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

RaySky::RaySky(const Scene& scene)
    : RaySky(scene.atmosphere, scene.environment.coarse.artistic_style) {}

RaySky::RaySky(const Atmosphere& atmosphere, ArtisticStyle style) : style_(style) {
  const Vector3f sun = atmosphere.sun_direction.cast<float>().normalized();
  const float sun_deg = std::asin(std::clamp(sun.z(), -1.0f, 1.0f)) / kDegree;
  SkyKey key = ClearSkyAt(sun_deg);
  for (Light* light : {&key.zenith, &key.horizon, &key.glow}) *light *= kSkyScale;
  is_night_ = sun_deg < -3.0f;
  lamps_are_lit_ = sun_deg < 4.0f || style_ == ArtisticStyle::kCyberpunk;
  exposure_ = key.exposure;

  if (is_night_) {
    sun_direction_ = Vector3f(0.52f, -0.44f, 0.73f).normalized();  // the moon
    sunlight_ = Light(.18f, .22f, .32f);
    disc_ = 0.8f;
  } else {
    // A little above the horizon at least, where shadows still end.
    sun_direction_ = Vector3f(sun.x(), sun.y(), std::max(sun.z(), 0.035f)).normalized();
    sunlight_ = SunThroughAir(sun_deg);
    disc_ = 12.0f;
  }

  const WeatherLook look = LookOf(atmosphere.weather);
  overcast_ = look.overcast;
  cover_ = look.cover;
  const float sky = Brightness(0.5f * (key.zenith + key.horizon)) + 0.10f * Brightness(sunlight_);
  // At night clouds throw back what light there is below them.
  const Light grey = look.tint * (sky * (is_night_ ? std::max(1.6f, look.light) : look.light));
  zenith_ = Blend(key.zenith, grey * 0.9f, overcast_);
  horizon_ = Blend(key.horizon, grey * 1.08f, overcast_);
  glow_ = key.glow * (1.0f - overcast_);
  cloud_ =
      Blend(Light::Constant(Brightness(key.horizon)) * 0.55f + 0.36f * sunlight_, grey, overcast_);
  sunlight_ *= 1.0f - 0.97f * std::min(1.0f, 1.25f * overcast_);
  disc_ *= 1.0f - std::min(1.0f, 1.3f * overcast_);
  stars_ = is_night_ ? 1.0f - overcast_ : 0.0f;
  air_ = horizon_;

  if (style_ == ArtisticStyle::kCyberpunk) {
    // Evening over a city, whatever the hour.
    const float day = std::clamp(Brightness(zenith_) / 0.25f, 0.12f, 1.0f);
    zenith_ = Blend(zenith_, Light(.016f, .010f, .075f) * (0.6f + 0.6f * day), 0.92f);
    horizon_ = Blend(horizon_, Light(.42f, .055f, .26f) * (0.35f + 0.65f * day), 0.85f);
    glow_ = Light(.55f, .12f, .30f) * (0.3f + 0.7f * day);
    cloud_ = Light(.16f, .05f, .22f) * (0.3f + 0.7f * day);
    air_ = Light(.16f, .045f, .20f) * (0.3f + 0.7f * day);
    sunlight_ *= Light(.34f, .22f, .42f);
    exposure_ *= 1.6f;
  }
  const double visibility_m = std::max(1.0, atmosphere.visibility_m);
  extinction_pm_ = static_cast<float>(2.9957 / visibility_m);
}

Light RaySky::Ambient(const Vector3f& normal) const {
  const float up = 0.5f + 0.5f * normal.z();
  // The sky is brighter near the sun and the horizon; lit ground shines back from below.
  const Light sky = 0.62f * zenith_ + 0.50f * horizon_ +
                    glow_ * (0.22f * std::max(0.0f, normal.dot(sun_direction_)));
  // Eyes take shadows for less blue than they are.
  const Light white = Blend(sky, Light::Constant(Brightness(sky)), 0.45f);
  const Light ground =
      Light(.20f, .19f, .13f) * (sunlight_ * std::max(0.1f, sun_direction_.z()) + sky);
  return white * up + ground * (1.0f - up);
}

Light RaySky::Smooth(const Vector3f& direction) const {
  const float up = std::max(0.0f, direction.z());
  const float high = 1.0f - std::pow(1.0f - up, 3.2f);
  Light light = Blend(horizon_, zenith_, high);
  const float toward = std::max(0.0f, direction.dot(sun_direction_));
  light += glow_ * (std::pow(toward, 5.0f) * (1.0f - 0.75f * up));
  return light;
}

float RaySky::CloudAt(const Vector3f& direction) const {
  if (direction.z() < 0.02f || cover_ <= 0.0f) return 0.0f;
  // A level of clouds, bent down towards the horizon.
  const float scale = 1.9f / (direction.z() + 0.14f);
  const float x = direction.x() * scale, y = direction.y() * scale;
  const float detail_limit = 0.012f * scale;
  const float puffs = DetailNoise(x + 3.7f, y + 1.3f, 2.1f, 6, 0.52f, detail_limit, 301);
  const float density = puffs + 1.55f * cover_ - 0.86f;
  const float low = std::clamp((direction.z() - 0.02f) / 0.10f, 0.0f, 1.0f);
  return std::clamp(1.7f * density, 0.0f, 1.0f) * low;
}

Light RaySky::At(const Vector3f& direction) const {
  Light light = Smooth(direction);
  const float toward = direction.dot(sun_direction_);
  if (stars_ > 0.0f && direction.z() > 0.0f) {
    // One star at most in each cell of a grid on the sky.
    const float u = std::atan2(direction.y(), direction.x()) * 60.0f, v = direction.z() * 70.0f;
    const auto i = static_cast<std::uint32_t>(static_cast<int>(std::floor(u)) + 1000);
    const auto j = static_cast<std::uint32_t>(std::floor(v));
    const float draw = UnitHash(i, j, 302);
    if (draw < 0.22f) {
      const float du = u - std::floor(u) - 0.15f - 0.7f * UnitHash(i, j, 303);
      const float dv = v - std::floor(v) - 0.15f - 0.7f * UnitHash(i, j, 304);
      const float size = 0.035f + 0.06f * UnitHash(i, j, 305);
      const float spark = std::clamp(1.0f - std::hypot(du, dv) / size, 0.0f, 1.0f);
      light += stars_ * 0.55f * spark * UnitHash(i, j, 306) * std::min(1.0f, 4.0f * direction.z());
    }
  }
  const float cloud = CloudAt(direction);
  if (disc_ > 0.0f && toward > 0.9f) {
    const float edge = is_night_ ? 0.99968f : 0.99984f;
    const float disc = std::clamp((toward - edge) / (0.25f * (1.0f - edge)), 0.0f, 1.0f);
    light += sunlight_ * (is_night_ ? 0.0f : 0.35f * std::pow(toward, 600.0f));
    light +=
        (is_night_ ? Light(1.0f, .98f, .9f) : sunlight_) * (disc * disc_ * (1.0f - 0.9f * cloud));
    if (is_night_) light += Light(.05f, .06f, .08f) * std::pow(toward, 300.0f);
  }
  if (cloud > 0.0f) {
    // Brighter towards the light, darker where they are thick.
    const float lit = 0.82f + 0.3f * std::pow(std::max(0.0f, toward), 4.0f) - 0.26f * cloud;
    light = Blend(light, cloud_ * lit, 0.92f * cloud);
  }
  return light;
}

Light RaySky::Air(const Vector3f& direction) const {
  const float toward = std::max(0.0f, direction.dot(sun_direction_));
  return air_ * 0.94f + glow_ * (0.45f * std::pow(toward, 6.0f));
}

float RaySky::Clarity(float distance_m) const { return std::exp(-extinction_pm_ * distance_m); }

}  // namespace latticeworld
