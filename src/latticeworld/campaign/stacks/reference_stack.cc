#include "latticeworld/campaign/stacks/reference_stack.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "latticeworld/reference_navigator/navigator.h"

namespace latticeworld {
namespace {

// What is left of a species' limits to correct its way with.
constexpr double kTurnReserve = 0.7;
// The goal of the navigator, by that of the task: noise must not carry it out again.
constexpr double kGoalShare = 0.7;

NavigatorOptions OptionsFor(const StackTask& task) {
  NavigatorOptions options;
  NavigatorRobot& robot = options.robot;
  robot.radius_m = task.robot.limits.radius_m;
  robot.max_speed_mps = std::min(task.robot.top_speed_mps, task.species.top_speed_mps);
  robot.max_reverse_mps = 0.3 * robot.max_speed_mps;
  robot.max_yaw_rate_radps = kTurnReserve * task.species.turn_rate_radps;
  robot.max_acceleration_mps2 = task.species.acceleration_mps2;
  robot.max_slope_rad = task.robot.limits.max_slope_rad;
  robot.max_step_m = task.robot.limits.max_step_m;
  robot.height_m = task.species.height_m;
  const auto& vehicle = task.species.vehicle;
  if (vehicle && vehicle->drive == DriveKind::kAckermann)
    robot.min_turn_radius_m = vehicle->wheelbase_m / std::tan(0.9 * vehicle->max_steering_rad);
  options.goal_radius_m = kGoalShare * task.task.goal_radius_m;
  return options;
}

NavigatorPose PoseOf(const StackInput& input) {
  return {input.time_s, input.map_from_base, input.speed_mps, input.yaw_rate_radps};
}

class ReferenceStack final : public RobotStack {
 public:
  bool UsesScans() const override { return true; }

  Status Begin(const StackTask& task, const StackInput& start) override {
    LW_ASSIGN_OR_RETURN(navigator_, Navigator::Create(OptionsFor(task)));
    navigator_->SetMap({task.geometry, task.occupancy});
    return navigator_->SetGoal(task.task.goal, std::nullopt, PoseOf(start));
  }

  StackOutput Update(const StackInput& input) override {
    for (const StackScan& scan : input.scans) {
      navigator_->See({scan.time_s, scan.map_from_sensor, scan.hits_m, scan.misses_m, scan.planar});
    }
    const NavigatorOutput said = navigator_->Update(PoseOf(input));
    StackOutput output;
    output.speed_mps = said.speed_mps;
    output.yaw_rate_radps = said.yaw_rate_radps;
    if (said.state == NavigatorState::kArrived) output.state = StackState::kArrived;
    if (said.state == NavigatorState::kFailed || said.state == NavigatorState::kIdle) {
      output.state = StackState::kFailed;
      output.why = said.why.ok() ? "it gave up without a reason" : said.why.ToString();
    }
    return output;
  }

 private:
  std::unique_ptr<Navigator> navigator_;
};

}  // namespace

std::unique_ptr<RobotStack> MakeReferenceStack() { return std::make_unique<ReferenceStack>(); }

}  // namespace latticeworld
