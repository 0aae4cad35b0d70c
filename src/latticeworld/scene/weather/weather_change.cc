#include "latticeworld/scene/weather/weather_change.h"

#include <array>
#include <cmath>
#include <string>

#include "latticeworld/common/range.h"
#include "latticeworld/common/text.h"
#include "latticeworld/scene/weather/sun.h"

namespace latticeworld {
namespace {

// What moves evenly from one atmosphere to another, besides wind, air and hour.
constexpr std::array<double Atmosphere::*, 10> kEven = {
    &Atmosphere::rain_mmph,      &Atmosphere::snowfall_mmph, &Atmosphere::cloud_cover,
    &Atmosphere::gust_mps,       &Atmosphere::direct_light,  &Atmosphere::diffuse_light,
    &Atmosphere::ground_wetness, &Atmosphere::snow_depth_m,  &Atmosphere::blown_sand,
    &Atmosphere::water_rise_m};
constexpr double kAlike = 1e-9;

double Moved(double from, double to, double share) { return from + share * (to - from); }

// What the weather and its intensity decide.
void TakeWeather(const Atmosphere& weather, Atmosphere* target) {
  target->weather = weather.weather;
  target->intensity = weather.intensity;
  target->visibility_m = weather.visibility_m;
  target->rain_mmph = weather.rain_mmph;
  target->snowfall_mmph = weather.snowfall_mmph;
  target->cloud_cover = weather.cloud_cover;
  target->wind_mps = weather.wind_mps;
  target->gust_mps = weather.gust_mps;
  target->direct_light = weather.direct_light;
  target->diffuse_light = weather.diffuse_light;
  target->ground_wetness = weather.ground_wetness;
  target->snow_depth_m = weather.snow_depth_m;
  target->blown_sand = weather.blown_sand;
  target->water_rise_m = weather.water_rise_m;
}

void SetWind(double speed_mps, double heading_rad, Atmosphere* atmosphere) {
  atmosphere->wind_mps = {speed_mps * std::cos(heading_rad), speed_mps * std::sin(heading_rad),
                          0.0};
}

}  // namespace

bool IsEmpty(const WeatherChange& change) {
  const bool some = change.weather || change.intensity || change.wind_speed_mps ||
                    change.wind_heading_rad || change.gust_mps || change.visibility_m ||
                    change.ground_wetness || change.snow_depth_m || change.water_rise_m ||
                    change.hour;
  return !some;
}

std::vector<Violation> Validate(const WeatherChange& change) {
  std::vector<Violation> violations;
  const auto check = [&violations](const char* name, const std::optional<double>& value,
                                   const Range& range, const char* unit) {
    if (value.has_value()) CheckRange(name, *value, range, unit, &violations);
  };
  check("intensity", change.intensity, {0.0, 1.0}, "");
  check("wind_speed", change.wind_speed_mps, {0.0, 60.0}, " m/s");
  if (change.wind_heading_rad.has_value() && !std::isfinite(*change.wind_heading_rad)) {
    const std::string given = FormatDouble(*change.wind_heading_rad);
    violations.push_back({"out_of_range", "wind_heading", given + " is not finite", given});
  }
  check("gust", change.gust_mps, {0.0, 60.0}, " m/s");
  check("visibility", change.visibility_m, {5.0, 100000.0}, " m");
  check("ground_wetness", change.ground_wetness, {0.0, 1.0}, "");
  check("snow_depth", change.snow_depth_m, {0.0, 2.0}, " m");
  check("water_rise", change.water_rise_m, {-5.0, 5.0}, " m");
  check("hour", change.hour, {0.0, 24.0, false, true}, " h");
  CheckRange("transition", change.transition_s, {0.0, 86400.0}, " s", &violations);
  return violations;
}

Atmosphere TargetOf(const Atmosphere& now, const WeatherChange& change,
                    const CoarseAttributes& coarse, double desert_wind_mps,
                    double calm_heading_rad) {
  Atmosphere target = now;
  const double heading_rad = change.wind_heading_rad.value_or(WindHeading(now, calm_heading_rad));
  if (change.weather.has_value() || change.intensity.has_value()) {
    CoarseAttributes wanted = coarse;
    wanted.weather = change.weather.value_or(now.weather);
    const double usual = wanted.weather == now.weather ? now.intensity : kUsualIntensity;
    TakeWeather(DeriveAtmosphere(wanted, desert_wind_mps, heading_rad, now.latitude_deg,
                                 change.intensity.value_or(usual)),
                &target);
  }
  const double speed_mps = target.wind_mps.norm();
  if (change.wind_speed_mps.has_value()) {
    // Gusts grow and fall with the wind that they are of.
    const double ratio = speed_mps > 0.0 ? target.gust_mps / speed_mps : kGustsOverMean;
    target.gust_mps = ratio * *change.wind_speed_mps;
  }
  if (change.wind_speed_mps.has_value() || change.wind_heading_rad.has_value()) {
    SetWind(change.wind_speed_mps.value_or(speed_mps), heading_rad, &target);
  }
  target.gust_mps = change.gust_mps.value_or(target.gust_mps);
  target.visibility_m = change.visibility_m.value_or(target.visibility_m);
  target.ground_wetness = change.ground_wetness.value_or(target.ground_wetness);
  target.snow_depth_m = change.snow_depth_m.value_or(target.snow_depth_m);
  target.water_rise_m = change.water_rise_m.value_or(target.water_rise_m);
  target.hour = change.hour.value_or(target.hour);
  SetSun(&target);
  return target;
}

double WindHeading(const Atmosphere& atmosphere, double calm_heading_rad) {
  const Eigen::Vector3d& wind_mps = atmosphere.wind_mps;
  return wind_mps.isZero(0.0) ? calm_heading_rad : std::atan2(wind_mps.y(), wind_mps.x());
}

bool AreAlike(const Atmosphere& a, const Atmosphere& b) {
  for (double Atmosphere::*const field : kEven) {
    if (std::abs(a.*field - b.*field) > kAlike) return false;
  }
  return a.weather == b.weather && std::abs(a.intensity - b.intensity) <= kAlike &&
         std::abs(1.0 / a.visibility_m - 1.0 / b.visibility_m) <= kAlike / a.visibility_m &&
         (a.wind_mps - b.wind_mps).norm() <= kAlike && std::abs(a.hour - b.hour) <= kAlike;
}

Atmosphere Between(const Atmosphere& from, const Atmosphere& to, double share) {
  if (share <= 0.0) return from;
  if (share >= 1.0) return to;
  Atmosphere now = to;
  now.visibility_m = 1.0 / Moved(1.0 / from.visibility_m, 1.0 / to.visibility_m, share);
  for (double Atmosphere::*const field : kEven) {
    now.*field = Moved(from.*field, to.*field, share);
  }
  now.wind_mps = from.wind_mps + share * (to.wind_mps - from.wind_mps);
  const double ahead_h = to.hour < from.hour ? to.hour + 24.0 - from.hour : to.hour - from.hour;
  now.hour = std::fmod(from.hour + share * ahead_h, 24.0);
  SetSun(&now);
  return now;
}

}  // namespace latticeworld
