#include "latticeworld/exporting/picture_light.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/exporting/picture_style.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

Color Grey(float value) { return {value, value, value}; }

// Azimuth kept, elevation brought into what shows relief.
Eigen::Vector3f ReadableDirection(const Eigen::Vector3d& direction) {
  constexpr double kLowest_rad = 0.48, kHighest_rad = 0.95;
  const double horizontal = direction.head<2>().norm();
  const double elevation_rad =
      std::clamp(std::atan2(direction.z(), horizontal), kLowest_rad, kHighest_rad);
  const double azimuth_rad =
      horizontal > 1e-6 ? std::atan2(direction.y(), direction.x()) : -0.75 * M_PI;
  return Eigen::Vector3d(std::cos(elevation_rad) * std::cos(azimuth_rad),
                         std::cos(elevation_rad) * std::sin(azimuth_rad), std::sin(elevation_rad))
      .cast<float>();
}

void ApplyTimeOfDay(TimeOfDay time, PictureLight* light) {
  switch (time) {
    case TimeOfDay::kDawn:
      light->sun = FromRgb(255, 205, 170) * 0.95f;
      light->ambient = FromRgb(150, 160, 200) * 0.62f;
      light->sky_high = FromRgb(108, 142, 196);
      light->sky_low = FromRgb(252, 214, 188);
      light->fog = FromRgb(226, 206, 206);
      break;
    case TimeOfDay::kDusk:
      light->sun = FromRgb(255, 186, 128) * 0.95f;
      light->ambient = FromRgb(136, 146, 198) * 0.62f;
      light->sky_high = FromRgb(72, 92, 150);
      light->sky_low = FromRgb(250, 170, 110);
      light->fog = FromRgb(214, 170, 150);
      break;
    case TimeOfDay::kNight:
      light->sun = FromRgb(140, 170, 235) * 0.5f;
      light->ambient = FromRgb(100, 122, 186) * 0.58f;
      light->sky_high = FromRgb(9, 14, 34);
      light->sky_low = FromRgb(34, 50, 88);
      light->fog = FromRgb(40, 52, 80);
      light->is_night = true;
      light->stars = 1.0f;
      break;
    case TimeOfDay::kMorning:
    case TimeOfDay::kNoon:
    case TimeOfDay::kAfternoon:
    case TimeOfDay::kDay:
      light->sun = FromRgb(255, 246, 228) * 0.92f;
      light->ambient = FromRgb(196, 212, 240) * 0.52f;
      light->sky_high = FromRgb(92, 152, 214);
      light->sky_low = FromRgb(214, 232, 246);
      light->fog = FromRgb(206, 220, 232);
      break;
  }
}

// Clouds take sun and give even light; what falls or blows colours the air.
void ApplyWeather(Weather weather, PictureLight* light) {
  const auto overcast = [light](float share, const Color& sky) {
    const float brightness = light->is_night ? 0.22f : 1.0f;
    light->ambient += light->sun * (0.3f * share);
    light->sun *= 1.0f - 0.6f * share;
    light->shadow *= 1.0f - 0.6f * share;
    light->sky_high = Mix(light->sky_high, sky * (0.82f * brightness), share);
    light->sky_low = Mix(light->sky_low, sky * brightness, 0.75f * share);
    light->fog = Mix(light->fog, sky * brightness, share);
    light->stars *= 1.0f - share;
  };
  switch (weather) {
    case Weather::kSunny:
      break;
    case Weather::kCloudy:
      overcast(0.7f, FromRgb(196, 204, 212));
      break;
    case Weather::kRain:
      overcast(0.95f, FromRgb(150, 160, 172));
      light->ambient *= 0.88f;
      break;
    case Weather::kSnow:
      overcast(0.85f, FromRgb(222, 226, 232));
      break;
    case Weather::kFog:
      overcast(0.9f, FromRgb(214, 218, 221));
      break;
    case Weather::kSandstorm:
      overcast(0.85f, FromRgb(214, 176, 122));
      light->ambient = Times(light->ambient, FromRgb(255, 222, 176));
      break;
  }
}

}  // namespace

PictureLight MapLight() {
  PictureLight light;
  light.direction = Eigen::Vector3f(-1.0f, 1.0f, 1.25f).normalized();
  light.sun = FromRgb(255, 250, 238) * 0.74f;
  light.ambient = FromRgb(232, 240, 255) * 0.49f;
  light.shadow = 0.8f;
  light.sky_high = light.sky_low = light.fog = Grey(1.0f);
  return light;
}

PictureLight SceneLight(const Scene& scene) {
  PictureLight light;
  light.direction = ReadableDirection(scene.atmosphere.sun_direction);
  ApplyTimeOfDay(scene.environment.coarse.time_of_day, &light);
  // A low sun still lights level ground well.
  light.sun *= std::clamp(0.6f / light.direction.z(), 0.9f, 1.3f);
  ApplyWeather(scene.atmosphere.weather, &light);
  ApplyStyle(scene.environment.coarse.artistic_style, &light);
  return light;
}

}  // namespace latticeworld
