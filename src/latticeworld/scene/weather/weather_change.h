#ifndef LATTICEWORLD_SCENE_WEATHER_WEATHER_CHANGE_H_
#define LATTICEWORLD_SCENE_WEATHER_WEATHER_CHANGE_H_

#include <optional>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/environment/attributes.h"
#include "latticeworld/scene/weather/atmosphere.h"

namespace latticeworld {

// What somebody wants the weather to become. What is not said follows from `weather` and
// `intensity` where one of the two is given (falling snow lies, rain wets the ground, storms blow),
// and stays as it is otherwise.
struct WeatherChange {
  std::optional<Weather> weather;
  std::optional<double> intensity;         // [0, 1]; none: usual for another weather
  std::optional<double> wind_speed_mps;    // mean, [0, 60]
  std::optional<double> wind_heading_rad;  // where it blows to, 0 east, counter-clockwise; finite
  std::optional<double> gust_mps;          // peak over the mean, [0, 60]
  std::optional<double> visibility_m;      // [5, 100000]
  std::optional<double> ground_wetness;    // [0, 1]
  std::optional<double> snow_depth_m;      // [0, 2]
  std::optional<double> water_rise_m;      // [-5, 5]
  std::optional<double> hour;              // by the sun, [0, 24); time goes on to it, never back
  double transition_s = 0.0;               // over which values move, [0, 86400]; 0: at once
};
// True when nothing is asked for, whatever the transition.
bool IsEmpty(const WeatherChange& change);
// Every violation, each with the name of the field.
std::vector<Violation> Validate(const WeatherChange& change);

// The atmosphere that the change ends in. coarse: of the world's environment, for the season and
// the land; its weather is not looked at. change: valid. calm_heading_rad: where the wind
// blows to when it rises from a calm and the change does not say it.
Atmosphere TargetOf(const Atmosphere& now, const WeatherChange& change,
                    const CoarseAttributes& coarse, double desert_wind_mps,
                    double calm_heading_rad = 0.0);

// Returns where the mean wind blows to [rad], (-pi, pi]; in a calm calm_heading_rad.
double WindHeading(const Atmosphere& atmosphere, double calm_heading_rad);

// True when nothing moves on the way from one to the other but by rounding.
bool AreAlike(const Atmosphere& a, const Atmosphere& b);

// Returns the atmosphere on the way from one to another of the same place and day: share 0 .. 1.
// What is seen through, the air's extinction, moves evenly, and so does everything else that is a
// number; the hour goes on. The weather's name and its intensity are those of `to` as soon as share
// is over 0.
Atmosphere Between(const Atmosphere& from, const Atmosphere& to, double share);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_WEATHER_WEATHER_CHANGE_H_
