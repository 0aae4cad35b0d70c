#include "latticeworld/rendering/ray/picture_light.h"

#include "latticeworld/rendering/looks/picture_style.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

void ApplyTimeOfDay(TimeOfDay time, PictureSky* sky) {
  switch (time) {
    case TimeOfDay::kDawn:
      sky->high = FromRgb(108, 142, 196);
      sky->low = FromRgb(252, 214, 188);
      break;
    case TimeOfDay::kDusk:
      sky->high = FromRgb(72, 92, 150);
      sky->low = FromRgb(250, 170, 110);
      break;
    case TimeOfDay::kNight:
      sky->high = FromRgb(9, 14, 34);
      sky->low = FromRgb(34, 50, 88);
      sky->is_night = true;
      sky->stars = 1.0f;
      break;
    case TimeOfDay::kMorning:
    case TimeOfDay::kNoon:
    case TimeOfDay::kAfternoon:
    case TimeOfDay::kDay:
      sky->high = FromRgb(92, 152, 214);
      sky->low = FromRgb(214, 232, 246);
      break;
  }
}

// Clouds grey the sky; what falls or blows colours it.
void ApplyWeather(Weather weather, PictureSky* sky) {
  const auto overcast = [sky](float share, const Color& grey) {
    const float brightness = sky->is_night ? 0.22f : 1.0f;
    sky->high = Mix(sky->high, grey * (0.82f * brightness), share);
    sky->low = Mix(sky->low, grey * brightness, 0.75f * share);
    sky->stars *= 1.0f - share;
  };
  switch (weather) {
    case Weather::kSunny:
      break;
    case Weather::kCloudy:
      overcast(0.7f, FromRgb(196, 204, 212));
      break;
    case Weather::kRain:
      overcast(0.95f, FromRgb(150, 160, 172));
      break;
    case Weather::kSnow:
      overcast(0.85f, FromRgb(222, 226, 232));
      break;
    case Weather::kFog:
      overcast(0.9f, FromRgb(214, 218, 221));
      break;
    case Weather::kSandstorm:
      overcast(0.85f, FromRgb(214, 176, 122));
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
  return light;
}

PictureSky SceneSky(const Scene& scene) {
  PictureSky sky;
  ApplyTimeOfDay(scene.environment.coarse.time_of_day, &sky);
  ApplyWeather(scene.atmosphere.weather, &sky);
  ApplyStyle(scene.environment.coarse.artistic_style, &sky);
  return sky;
}

}  // namespace latticeworld
