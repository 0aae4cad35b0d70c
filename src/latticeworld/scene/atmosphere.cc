#include "latticeworld/scene/atmosphere.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kLatitude_rad = 45.0 * kDegree;          // of every world
constexpr double kObliquity_rad = 23.44 * kDegree;        // of the ecliptic
constexpr double kTwilightElevation_rad = 3.0 * kDegree;  // of the sun at dawn and dusk

// What a weather does to sight, water and light.
struct WeatherEffects {
  double visibility_m;
  double rain_mmph;
  double wind_mps;
  double direct_light;  // share of the direct sunlight that comes through
  double diffuse_light;
};

// Visibility after the classes of the WMO Guide to Instruments and Methods of Observation (WMO-No.
// 8) and Manual on Codes (WMO-No. 306): fog below 1 km, moderate snow 0.5 to 1 km, moderate rain 2
// to 10 km, sandstorm below 1 km, clear air above 10 km. Rain: moderate is 2.5 to 10 mm/h. Wind:
// Beaufort 1 (fog) to 7 (sandstorm, which needs about 15 m/s to lift sand).
WeatherEffects EffectsOf(Weather weather) {
  switch (weather) {
    case Weather::kSunny:
      return {20000.0, 0.0, 2.0, 1.0, 0.8};
    case Weather::kCloudy:
      return {15000.0, 0.0, 4.0, 0.35, 1.0};
    case Weather::kRain:
      return {4000.0, 5.0, 7.0, 0.15, 0.8};
    case Weather::kSnow:
      return {800.0, 0.0, 5.0, 0.2, 1.0};
    case Weather::kFog:
      return {200.0, 0.0, 0.5, 0.15, 0.9};
    case Weather::kSandstorm:
      return {300.0, 0.0, 15.0, 0.2, 0.6};
  }
  return {20000.0, 0.0, 2.0, 1.0, 0.8};
}

// Winter ground is snow-covered unless rain washes most of it away; falling snow lies in every
// season, thinner outside winter.
double SnowDepthOf(Season season, Weather weather) {
  if (season == Season::kWinter) {
    if (weather == Weather::kSnow) return 0.3;
    return weather == Weather::kRain ? 0.05 : 0.1;
  }
  return weather == Weather::kSnow ? 0.05 : 0.0;
}

// Solar declination: solstices for summer and winter, equinoxes between.
double DeclinationOf(Season season) {
  if (season == Season::kSummer) return kObliquity_rad;
  return season == Season::kWinter ? -kObliquity_rad : 0.0;
}

// Hour angle of the sun, 0 at solar noon, positive in the afternoon [rad].
double HourAngleOf(TimeOfDay time, double declination_rad) {
  const double twilight_rad = std::acos(
      (std::sin(kTwilightElevation_rad) - std::sin(kLatitude_rad) * std::sin(declination_rad)) /
      (std::cos(kLatitude_rad) * std::cos(declination_rad)));
  constexpr double kHour_rad = 15.0 * kDegree;
  switch (time) {
    case TimeOfDay::kDawn:
      return -twilight_rad;
    case TimeOfDay::kMorning:
      return -3.0 * kHour_rad;
    case TimeOfDay::kNoon:
      return 0.0;
    case TimeOfDay::kAfternoon:
      return 3.0 * kHour_rad;
    case TimeOfDay::kDusk:
      return twilight_rad;
    case TimeOfDay::kNight:
      return M_PI;
    case TimeOfDay::kDay:
      return -1.0 * kHour_rad;
  }
  return 0.0;
}

// Share of the overhead clear-sky sun that reaches the ground: air mass after Kasten and Young
// (1989), transmission 0.7^(AM^0.678) after Meinel and Meinel (1976), 1 for the sun at the zenith.
double ClearSkyIntensity(double elevation_rad) {
  if (elevation_rad <= 0.0) return 0.0;
  const double elevation_deg = elevation_rad / kDegree;
  const double air_mass =
      1.0 / (std::sin(elevation_rad) + 0.50572 * std::pow(elevation_deg + 6.07995, -1.6364));
  return std::min(1.0, std::pow(0.7, std::pow(air_mass, 0.678)) / 0.7);
}

}  // namespace

Atmosphere DeriveAtmosphere(const CoarseAttributes& coarse, double desert_wind_mps,
                            double wind_heading_rad) {
  const WeatherEffects effects = EffectsOf(coarse.weather);
  Atmosphere atmosphere;
  atmosphere.weather = coarse.weather;
  atmosphere.visibility_m = effects.visibility_m;
  atmosphere.rain_mmph = effects.rain_mmph;
  atmosphere.snow_depth_m = SnowDepthOf(coarse.season, coarse.weather);

  const bool desert_wind =
      coarse.terrain_type == TerrainType::kDesert || coarse.weather == Weather::kSandstorm;
  const double wind_mps =
      desert_wind ? std::max(effects.wind_mps, desert_wind_mps) : effects.wind_mps;
  atmosphere.wind_mps = {wind_mps * std::cos(wind_heading_rad),
                         wind_mps * std::sin(wind_heading_rad), 0.0};

  // Equatorial to horizontal coordinates, as an east-north-up vector.
  const double declination_rad = DeclinationOf(coarse.season);
  const double hour_rad = HourAngleOf(coarse.time_of_day, declination_rad);
  const double up = std::sin(kLatitude_rad) * std::sin(declination_rad) +
                    std::cos(kLatitude_rad) * std::cos(declination_rad) * std::cos(hour_rad);
  atmosphere.sun_direction =
      Eigen::Vector3d(-std::cos(declination_rad) * std::sin(hour_rad),
                      std::cos(kLatitude_rad) * std::sin(declination_rad) -
                          std::sin(kLatitude_rad) * std::cos(declination_rad) * std::cos(hour_rad),
                      up)
          .normalized();
  atmosphere.sun_intensity =
      effects.direct_light * ClearSkyIntensity(std::asin(std::clamp(up, -1.0, 1.0)));
  constexpr double kNightSky = 0.05, kDaySky = 0.3;
  const double daylight = std::clamp(up / 0.5, 0.0, 1.0);  // full once the sun is 30 degrees high
  atmosphere.ambient_intensity = kNightSky + kDaySky * effects.diffuse_light * std::sqrt(daylight);
  return atmosphere;
}

}  // namespace latticeworld
