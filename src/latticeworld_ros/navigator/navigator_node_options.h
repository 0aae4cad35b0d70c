#ifndef LATTICEWORLD_ROS_NAVIGATOR_NAVIGATOR_NODE_OPTIONS_H_
#define LATTICEWORLD_ROS_NAVIGATOR_NAVIGATOR_NODE_OPTIONS_H_

#include <XmlRpcValue.h>

#include <array>
#include <cstdint>
#include <string>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/result.h"
#include "latticeworld/reference_navigator/navigator.h"

namespace latticeworld {

// What a navigator sees obstacles with that its map has not.
enum class NavigatorSensor : std::uint8_t { kNone, kScan, kPoints, kBoth };
constexpr std::array<EnumName<NavigatorSensor>, 4> EnumNames(NavigatorSensor) {
  return {{{NavigatorSensor::kNone, "none"},
           {NavigatorSensor::kScan, "scan"},
           {NavigatorSensor::kPoints, "points"},
           {NavigatorSensor::kBoth, "both"}}};
}

// The parameters of navigator; launch_cfg/navigator.yaml has one entry a field.
struct NavigatorNodeOptions {
  std::string robot = "robot";
  std::string global_frame = "map";
  std::string base_frame;  // empty: what the odometry says
  NavigatorSensor sensor = NavigatorSensor::kScan;
  std::string robot_species = "wheeled robot";  // a built-in one, whose radius the robot has
  double robot_radius_m = 0.0;                  // 0: that of robot_species, else [0.05, 5]
  double sensor_range_m = 20.0;                 // [1, 200] beyond it nothing is seen
  double control_rate_hz = 10.0;                // [1, 100] in simulated time
  double odom_timeout_s = 2.0;                  // [0.1, 60] without odometry or tf, a goal ends
  double goal_heading_tolerance_rad = 3.1416;   // (0, 3.1416]; from 3.14 on any heading will do
  double time_limit_s = 0.0;                    // [0, 1e6] of one goal; 0: none
  // Its robot's radius, heading tolerance and time limit are those above.
  NavigatorOptions navigator;
};

// The options that the node's private parameters say; absent ones keep their defaults. Errors:
// INVALID_ARGUMENT naming every unknown name, wrong type and illegal value.
Result<NavigatorNodeOptions> NavigatorOptionsFromParameters(const XmlRpc::XmlRpcValue& parameters);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NAVIGATOR_NAVIGATOR_NODE_OPTIONS_H_
