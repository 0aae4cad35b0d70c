#include "latticeworld_ros/conversion/weather_conversion.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "latticeworld/common/request_fields.h"
#include "latticeworld_ros/conversion/geometry_conversion.h"

namespace latticeworld {
namespace {

// Reads at most one number: none from an empty list or NaN; more than one are a violation.
std::optional<double> ReadOne(const char* field, const std::vector<double>& given,
                              std::vector<Violation>* violations) {
  if (given.size() > 1) {
    const std::string count = std::to_string(given.size());
    violations->push_back(
        {"wrong_size", field, count + " numbers are given; legal are none or one", count});
    return std::nullopt;
  }
  if (given.empty() || std::isnan(given.front())) return std::nullopt;
  return given.front();
}

}  // namespace

latticeworld_msgs::Weather ToWeatherMessage(const Atmosphere& atmosphere, double remaining_s,
                                            ros::Time stamp, const std::string& world_id) {
  latticeworld_msgs::Weather message;
  message.header.stamp = stamp;
  message.header.frame_id = kMapFrame;
  message.world_id = world_id;
  message.weather = std::string(NameOf(atmosphere.weather));
  message.intensity = atmosphere.intensity;
  message.visibility = atmosphere.visibility_m;
  message.rain = atmosphere.rain_mmph;
  message.snowfall = atmosphere.snowfall_mmph;
  message.cloud_cover = atmosphere.cloud_cover;
  message.wind = ToVector3(atmosphere.wind_mps);
  message.gust = atmosphere.gust_mps;
  message.hour = atmosphere.hour;
  message.sun_direction = ToVector3(atmosphere.sun_direction);
  message.sun_intensity = atmosphere.sun_intensity;
  message.ambient_intensity = atmosphere.ambient_intensity;
  message.ground_wetness = atmosphere.ground_wetness;
  message.snow_depth = atmosphere.snow_depth_m;
  message.blown_sand = atmosphere.blown_sand;
  message.water_rise = atmosphere.water_rise_m;
  message.remaining = remaining_s;
  return message;
}

Result<WeatherChange> ToWeatherChange(const latticeworld_msgs::SetWeather::Request& request) {
  std::vector<Violation> violations;
  WeatherChange change;
  if (!request.weather.empty()) {
    change.weather = ReadName<Weather>("weather", request.weather, &violations);
  }
  const auto read = [&violations](const char* field, const std::vector<double>& given) {
    return ReadOne(field, given, &violations);
  };
  change.intensity = read("intensity", request.intensity);
  change.wind_speed_mps = read("wind_speed", request.wind_speed);
  change.wind_heading_rad = read("wind_heading", request.wind_heading);
  change.gust_mps = read("gust", request.gust);
  change.visibility_m = read("visibility", request.visibility);
  change.ground_wetness = read("ground_wetness", request.ground_wetness);
  change.snow_depth_m = read("snow_depth", request.snow_depth);
  change.water_rise_m = read("water_rise", request.water_rise);
  change.hour = read("hour", request.hour);
  change.transition_s = std::isnan(request.transition) ? 0.0 : request.transition;
  if (violations.empty()) return change;
  return RefuseUnread("weather", std::move(violations), Validate(change));
}

}  // namespace latticeworld
