#include "latticeworld/reference_navigator/navigator_options.h"

#include <cmath>
#include <string>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

struct Check {
  std::vector<Violation> found;

  void In(const char* name, double value, double low, double high) {
    if (value >= low && value <= high) return;  // false for NaN
    Add(name, value, FormatDouble(low) + " to " + FormatDouble(high));
  }
  void Positive(const char* name, double value) {
    if (value > 0.0) return;
    Add(name, value, "above 0, infinity too");
  }
  void Add(const char* name, double value, const std::string& legal) {
    found.push_back({"out_of_range", name,
                     std::string(name) + " is " + FormatDouble(value) + "; legal is " + legal,
                     FormatDouble(value)});
  }
};

}  // namespace

std::vector<Violation> Validate(const NavigatorOptions& options) {
  Check check;
  const NavigatorRobot& robot = options.robot;
  check.In("robot.radius_m", robot.radius_m, 0.05, 5.0);
  check.In("robot.max_speed_mps", robot.max_speed_mps, 0.05, 20.0);
  check.In("robot.max_reverse_mps", robot.max_reverse_mps, 0.0, 20.0);
  check.In("robot.max_yaw_rate_radps", robot.max_yaw_rate_radps, 0.05, 20.0);
  check.In("robot.max_acceleration_mps2", robot.max_acceleration_mps2, 0.05, 50.0);
  check.In("robot.max_yaw_acceleration_radps2", robot.max_yaw_acceleration_radps2, 0.05, 100.0);
  check.In("robot.min_turn_radius_m", robot.min_turn_radius_m, 0.0, 20.0);
  check.In("robot.max_slope_rad", robot.max_slope_rad, 0.01, 1.4);
  check.In("robot.max_step_m", robot.max_step_m, 0.01, 5.0);
  check.In("robot.height_m", robot.height_m, 0.05, 10.0);
  check.In("goal_radius_m", options.goal_radius_m, 0.05, 20.0);
  check.Positive("goal_heading_tolerance_rad", options.goal_heading_tolerance_rad);
  check.In("closed_cost", options.closed_cost, 1, 100);
  check.In("cost_weight", options.cost_weight, 0.0, 100.0);
  check.In("clearance_weight", options.clearance_weight, 0.0, 100.0);
  check.In("clearance_m", options.clearance_m, 0.0, 10.0);
  check.In("local_size_m", options.local_size_m, 4.0, 200.0);
  check.In("local_resolution_m", options.local_resolution_m, 0.02, 1.0);
  if (options.local_size_m > 2000.0 * options.local_resolution_m) {
    check.Add("local_size_m", options.local_size_m,
              "at most 2000 of local_resolution_m, " + FormatDouble(options.local_resolution_m));
  }
  check.In("margin_m", options.margin_m, 0.0, 2.0);
  check.In("memory_s", options.memory_s, 0.5, 3600.0);
  check.In("lookahead_m", options.lookahead_m, 0.1, 20.0);
  check.In("horizon_s", options.horizon_s, 0.5, 10.0);
  check.In("patience_s", options.patience_s, 0.5, 600.0);
  check.In("recoveries", options.recoveries, 0, 100);
  check.Positive("time_limit_s", options.time_limit_s);
  return check.found;
}

}  // namespace latticeworld
