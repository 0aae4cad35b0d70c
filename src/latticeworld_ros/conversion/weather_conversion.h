#ifndef LATTICEWORLD_ROS_CONVERSION_WEATHER_CONVERSION_H_
#define LATTICEWORLD_ROS_CONVERSION_WEATHER_CONVERSION_H_

#include <ros/time.h>

#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/scene/weather/weather_change.h"
#include "latticeworld_ros/conversion/messages.h"

namespace latticeworld {

// remaining_s: until the weather stops moving.
latticeworld_msgs::Weather ToWeatherMessage(const Atmosphere& atmosphere, double remaining_s,
                                            ros::Time stamp, const std::string& world_id);

// What it says is for the simulator to judge. Errors: INVALID_ARGUMENT where the weather is no name
// of any, or a value is more than one number; then with everything that Validate has against the
// rest.
Result<WeatherChange> ToWeatherChange(const latticeworld_msgs::SetWeather::Request& request);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_WEATHER_CONVERSION_H_
