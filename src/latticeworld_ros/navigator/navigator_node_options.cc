#include "latticeworld_ros/navigator/navigator_node_options.h"

#include <ros/names.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "latticeworld/common/range.h"
#include "latticeworld/common/text.h"
#include "latticeworld/species/species_catalogue.h"
#include "latticeworld_ros/node/parameter_binding.h"

namespace latticeworld {
namespace {

constexpr Range kSensorRanges_m = {1.0, 200.0};
constexpr Range kControlRates_hz = {1.0, 100.0};
constexpr Range kOdomTimeouts_s = {0.1, 60.0};
constexpr Range kTimeLimits_s = {0.0, 1e6};
constexpr Range kRadii_m = {0.05, 5.0};  // and 0, that of the species
constexpr Range kHeadings_rad = {0.0, 3.1416, /*low_open=*/true};

// A parameter of the navigator, and the field that Validate(NavigatorOptions) names.
struct NavigatorParameter {
  const char* name;
  const char* field;
  BoundParameter bound;
};

std::vector<NavigatorParameter> ParametersOf(NavigatorOptions* options) {
  NavigatorRobot& robot = options->robot;
  return {
      {"goal_radius", "goal_radius_m", Bind(&options->goal_radius_m)},
      {"closed_cost", "closed_cost", Bind(&options->closed_cost)},
      {"unknown_is_free", "unknown_is_free", Bind(&options->unknown_is_free)},
      {"map_is_inflated", "map_is_inflated", Bind(&options->map_is_inflated)},
      {"cost_weight", "cost_weight", Bind(&options->cost_weight)},
      {"clearance_weight", "clearance_weight", Bind(&options->clearance_weight)},
      {"clearance", "clearance_m", Bind(&options->clearance_m)},
      {"local_size", "local_size_m", Bind(&options->local_size_m)},
      {"local_resolution", "local_resolution_m", Bind(&options->local_resolution_m)},
      {"margin", "margin_m", Bind(&options->margin_m)},
      {"memory", "memory_s", Bind(&options->memory_s)},
      {"lookahead", "lookahead_m", Bind(&options->lookahead_m)},
      {"horizon", "horizon_s", Bind(&options->horizon_s)},
      {"patience", "patience_s", Bind(&options->patience_s)},
      {"recoveries", "recoveries", Bind(&options->recoveries)},
      {"robot_height", "robot.height_m", Bind(&robot.height_m)},
      {"max_speed", "robot.max_speed_mps", Bind(&robot.max_speed_mps)},
      {"max_reverse_speed", "robot.max_reverse_mps", Bind(&robot.max_reverse_mps)},
      {"max_yaw_rate", "robot.max_yaw_rate_radps", Bind(&robot.max_yaw_rate_radps)},
      {"max_acceleration", "robot.max_acceleration_mps2", Bind(&robot.max_acceleration_mps2)},
      {"max_yaw_acceleration", "robot.max_yaw_acceleration_radps2",
       Bind(&robot.max_yaw_acceleration_radps2)},
      {"min_turn_radius", "robot.min_turn_radius_m", Bind(&robot.min_turn_radius_m)},
      {"max_slope", "robot.max_slope_rad", Bind(&robot.max_slope_rad)},
      {"max_step", "robot.max_step_m", Bind(&robot.max_step_m)},
  };
}

void CheckName(const char* parameter, const std::string& given, bool may_be_empty,
               std::vector<Violation>* violations) {
  std::string why;
  if (given.empty() ? may_be_empty : ros::names::validate(given, why)) return;
  violations->push_back({"out_of_range", parameter,
                         Quote(given) + " is no name; legal are letters, digits, _ and /" +
                             (why.empty() ? "" : ": " + why),
                         Quote(given)});
}

// The radius that is said, or that of the species.
void TakeRadius(NavigatorNodeOptions* options, std::vector<Violation>* violations) {
  double* const radius_m = &options->navigator.robot.radius_m;
  if (options->robot_radius_m != 0.0) {
    CheckRange("robot_radius", options->robot_radius_m, kRadii_m, " m", violations);
    if (kRadii_m.Contains(options->robot_radius_m)) *radius_m = options->robot_radius_m;
    return;
  }
  const std::string& name = options->robot_species;
  if (const Species* species = SpeciesCatalogue::BuiltIn()->Find(name)) {
    *radius_m = std::clamp(species->radius_m, kRadii_m.low, kRadii_m.high);
    return;
  }
  violations->push_back({"unknown_species", "robot_species",
                         Quote(name) +
                             " is no built-in species (`latticeworld species` lists them); of "
                             "another one robot_radius has to be said",
                         Quote(name)});
}

}  // namespace

Result<NavigatorNodeOptions> NavigatorOptionsFromParameters(const XmlRpc::XmlRpcValue& parameters) {
  NavigatorNodeOptions options;
  BoundParameters known = {
      {"robot", Bind(&options.robot)},
      {"global_frame", Bind(&options.global_frame)},
      {"base_frame", Bind(&options.base_frame)},
      {"sensor", Bind(&options.sensor)},
      {"robot_species", Bind(&options.robot_species)},
      {"robot_radius", Bind(&options.robot_radius_m)},
      {"sensor_range", Bind(&options.sensor_range_m)},
      {"control_rate", Bind(&options.control_rate_hz)},
      {"odom_timeout", Bind(&options.odom_timeout_s)},
      {"goal_heading_tolerance", Bind(&options.goal_heading_tolerance_rad)},
      {"time_limit", Bind(&options.time_limit_s)},
  };
  const std::vector<NavigatorParameter> own = ParametersOf(&options.navigator);
  for (const NavigatorParameter& parameter : own) known[parameter.name] = parameter.bound;
  std::vector<Violation> violations;
  ReadParameters(parameters, known, &violations);

  CheckName("robot", options.robot, /*may_be_empty=*/false, &violations);
  CheckName("global_frame", options.global_frame, /*may_be_empty=*/false, &violations);
  CheckName("base_frame", options.base_frame, /*may_be_empty=*/true, &violations);
  TakeRadius(&options, &violations);
  CheckRange("sensor_range", options.sensor_range_m, kSensorRanges_m, " m", &violations);
  CheckRange("control_rate", options.control_rate_hz, kControlRates_hz, " Hz", &violations);
  CheckRange("odom_timeout", options.odom_timeout_s, kOdomTimeouts_s, " s", &violations);
  const double tolerance_rad = options.goal_heading_tolerance_rad;
  CheckRange("goal_heading_tolerance", tolerance_rad, kHeadings_rad, " rad", &violations);
  // Half a turn either way is any heading.
  if (tolerance_rad < 3.14) options.navigator.goal_heading_tolerance_rad = tolerance_rad;
  CheckRange("time_limit", options.time_limit_s, kTimeLimits_s, " s", &violations);
  if (options.time_limit_s > 0.0) options.navigator.time_limit_s = options.time_limit_s;
  for (Violation& violation : Validate(options.navigator)) {
    for (const NavigatorParameter& parameter : own) {
      if (violation.pointer == parameter.field) violation.pointer = parameter.name;
    }
    violations.push_back(std::move(violation));
  }
  if (!violations.empty())
    return Status::FromViolations("parameters of navigator", std::move(violations));
  return options;
}

}  // namespace latticeworld
