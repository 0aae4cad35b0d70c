#include "latticeworld/scene/weather/atmosphere.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/scene/weather/sun.h"

namespace latticeworld {
namespace {

// ln(1 / 0.05): light over the meteorological optical range.
constexpr double kOpticalRangeDepth = 2.996;
constexpr double kClearVisibility_m = 20000.0;
// Grades from `slight` at intensity 0 over the geometric middle at 0.5 to `extreme` at 1: people
// and weather services grade rain, snow and fog by factors, not by differences.
double Graded(double slight, double extreme, double intensity) {
  return slight * std::pow(extreme / slight, intensity);
}

// Visibility where air of that extinction [1/km] is added to clear air [m].
double VisibilityWith(double extinction_per_km) {
  return kOpticalRangeDepth / (kOpticalRangeDepth / kClearVisibility_m + 1e-3 * extinction_per_km);
}

// Rainfall: slight below 2.5 mm/h, moderate to 10, heavy to 50 (WMO-No. 8). Visibility by the
// attenuation of light in rain, 1.076 R^0.67 dB/km (Carbonneau and Wisely 1998; ITU-R P.1814).
void Rain(double intensity, Atmosphere* air) {
  constexpr double kDecibel = 4.342945;  // per unit of optical depth
  air->rain_mmph = Graded(0.5, 50.0, intensity);
  air->visibility_m = VisibilityWith(1.076 * std::pow(air->rain_mmph, 0.67) / kDecibel);
  air->cloud_cover = 0.9 + 0.1 * intensity;
  air->ground_wetness = 1.0 - std::exp(-air->rain_mmph / 1.5);
  air->water_rise_m = 0.3 * intensity * intensity;  // a rise that small waters keep. Estimate.
}

// Snowfall as water: slight below 1 mm/h, moderate to 5 (WMO-No. 8). Visibility by the attenuation
// of light in dry snow, 5.55 S^1.38 dB/km (ITU-R P.1814, at 905 nm).
void Snow(double intensity, Atmosphere* air) {
  constexpr double kDecibel = 4.342945;
  air->snowfall_mmph = Graded(0.4, 10.0, intensity);
  air->visibility_m = VisibilityWith(5.55 * std::pow(air->snowfall_mmph, 1.38) / kDecibel);
  air->cloud_cover = 0.9 + 0.1 * intensity;
  air->ground_wetness = 0.2;
}

// Mean wind, visibility and light of each weather. Visibility: fog and sandstorms are below 1 km,
// dense fog below 40 m (WMO-No. 306, code table 4677; WMO-No. 8). Wind: Beaufort 1 (fog) to 9
// (strong sandstorms; sand is lifted from about 8 m/s on, Bagnold 1941). Light and wetness are
// estimates: the share that comes through thickens like a layer of cloud does, so that it falls
// exponentially with intensity, through the first value at the usual one.
void SetWeather(Weather weather, double intensity, Atmosphere* air) {
  double direct = 1.0, diffuse = 0.8, wind_mps = 2.0;
  switch (weather) {
    case Weather::kSunny:
      air->visibility_m = Graded(10000.0, 40000.0, intensity);
      air->cloud_cover = 0.2 * (1.0 - intensity);
      break;
    case Weather::kCloudy:
      air->visibility_m = 15000.0;
      air->cloud_cover = 0.6 + 0.4 * intensity;
      direct = 0.35, diffuse = 1.0, wind_mps = 4.0;
      break;
    case Weather::kRain:
      Rain(intensity, air);
      direct = 0.15, diffuse = 0.8, wind_mps = Graded(3.5, 14.0, intensity);
      break;
    case Weather::kSnow:
      Snow(intensity, air);
      direct = 0.2, diffuse = 1.0, wind_mps = Graded(2.5, 10.0, intensity);
      break;
    case Weather::kFog:
      air->visibility_m = Graded(1000.0, 40.0, intensity);
      air->cloud_cover = 1.0;
      air->ground_wetness = 0.15;
      direct = 0.15, diffuse = 0.9, wind_mps = 0.5;
      break;
    case Weather::kSandstorm:
      air->visibility_m = Graded(1000.0, 90.0, intensity);
      air->cloud_cover = 0.5;
      air->blown_sand = std::min(1.0, 2.0 * intensity);
      direct = 0.2, diffuse = 0.6, wind_mps = Graded(10.0, 22.5, intensity);
      break;
  }
  air->direct_light = std::pow(direct, 0.5 + intensity);
  air->diffuse_light = std::pow(diffuse, 0.5 + intensity);
  air->wind_mps = {wind_mps, 0.0, 0.0};
}

// Winter ground is snow-covered unless rain washes most of it away; falling snow lies in every
// season, thinner outside winter.
double SnowDepthOf(Season season, Weather weather, double intensity) {
  const double fallen_m = weather == Weather::kSnow ? 0.1 * intensity : 0.0;
  if (season != Season::kWinter) return fallen_m;
  return weather == Weather::kRain ? 0.05 : 0.1 + 4.0 * fallen_m;
}

}  // namespace

Atmosphere DeriveAtmosphere(const CoarseAttributes& coarse, double desert_wind_mps,
                            double wind_heading_rad, double latitude_deg, double intensity) {
  Atmosphere atmosphere;
  atmosphere.weather = coarse.weather;
  atmosphere.intensity = intensity;
  SetWeather(coarse.weather, intensity, &atmosphere);
  atmosphere.snow_depth_m = SnowDepthOf(coarse.season, coarse.weather, intensity);

  const bool desert_wind =
      coarse.terrain_type == TerrainType::kDesert || coarse.weather == Weather::kSandstorm;
  double wind_mps = atmosphere.wind_mps.norm();
  if (desert_wind) wind_mps = std::max(wind_mps, desert_wind_mps);
  atmosphere.wind_mps = {wind_mps * std::cos(wind_heading_rad),
                         wind_mps * std::sin(wind_heading_rad), 0.0};
  atmosphere.gust_mps = kGustsOverMean * wind_mps;

  atmosphere.latitude_deg = latitude_deg;
  atmosphere.day_of_year = DayOfYear(coarse.season, latitude_deg);
  atmosphere.hour = HourOf(coarse.time_of_day, atmosphere.day_of_year, latitude_deg);
  SetSun(&atmosphere);
  return atmosphere;
}

}  // namespace latticeworld
