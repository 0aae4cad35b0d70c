#include "latticeworld/reference_navigator/controller.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "latticeworld/reference_navigator/local_plan.h"
#include "latticeworld/reference_navigator/obstacle_layer.h"

namespace latticeworld {
namespace {

constexpr int kSpeeds = 7, kYawRates = 15;
constexpr double kStep_s = 0.1;

double Wrapped(double angle_rad) { return std::remainder(angle_rad, 2.0 * M_PI); }

// The place `ahead_m` along a way, or its end.
WorldPoint Ahead(const std::vector<WorldPoint>& way, double ahead_m) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double x_m = way[i].x_m - way[i - 1].x_m, y_m = way[i].y_m - way[i - 1].y_m;
    const double leg_m = std::hypot(x_m, y_m);
    if (leg_m >= ahead_m && leg_m > 0.0)
      return {way[i - 1].x_m + x_m * ahead_m / leg_m, way[i - 1].y_m + y_m * ahead_m / leg_m};
    ahead_m -= leg_m;
  }
  return way.back();
}

// What the robot would touch, as it stands somewhere.
class Room {
 public:
  Room(const ObstacleLayer& seen, const GlobalPlan& global, double radius_m)
      : seen_(seen), global_(global), radius_m_(radius_m) {}
  // Returns the room beside the robot [m]; below 0: it touches something.
  double At(WorldPoint at) const {
    if (!global_.geometry.Contains(at)) return -1.0;
    if (global_.prices[global_.geometry.CellAt(at)] == kClosedCell) return -0.01;
    return seen_.DistanceAt(at) - radius_m_;
  }

 private:
  const ObstacleLayer& seen_;
  const GlobalPlan& global_;
  double radius_m_;
};

struct Arc {
  PlanarState end;
  double least_room_m = std::numeric_limits<double>::infinity();
  double last_room_m = 0.0;
};

Arc Drive(const PlanarState& state, const DriveCommand& command, double horizon_s,
          const Room& room) {
  Arc arc;
  arc.end = state;
  const int steps = std::max(1, static_cast<int>(std::lround(horizon_s / kStep_s)));
  for (int i = 0; i < steps; ++i) {
    const double middle_rad = arc.end.heading_rad + 0.5 * kStep_s * command.yaw_rate_radps;
    arc.end.at.x_m += kStep_s * command.speed_mps * std::cos(middle_rad);
    arc.end.at.y_m += kStep_s * command.speed_mps * std::sin(middle_rad);
    arc.end.heading_rad += kStep_s * command.yaw_rate_radps;
    arc.last_room_m = room.At(arc.end.at);
    arc.least_room_m = std::min(arc.least_room_m, arc.last_room_m);
  }
  return arc;
}

bool CanSteer(const DriveCommand& command, const NavigatorRobot& robot) {
  return robot.min_turn_radius_m <= 0.0 ||
         std::abs(command.yaw_rate_radps) * robot.min_turn_radius_m <=
             std::abs(command.speed_mps) + 1e-9;
}

}  // namespace

std::optional<DriveCommand> ChooseArc(const PlanarState& state, const LocalPlan& plan,
                                      const ObstacleLayer& seen, const GlobalPlan& global,
                                      const NavigatorOptions& options, double period_s,
                                      double top_speed_mps) {
  const NavigatorRobot& robot = options.robot;
  if (plan.way().empty()) return std::nullopt;
  const Room room(seen, global, robot.radius_m);
  const double here_room_m = room.At(state.at);
  // A window of several periods: what is reached within the arc counts, not the next moment alone.
  const double reach_s = std::max(period_s, 0.3);
  const double fastest = std::min({robot.max_speed_mps, top_speed_mps,
                                   state.speed_mps + robot.max_acceleration_mps2 * reach_s});
  const double slowest =
      std::max(-robot.max_reverse_mps, state.speed_mps - robot.max_acceleration_mps2 * reach_s);
  const double most_turn = robot.max_yaw_acceleration_radps2 * reach_s;
  const double left = std::min(robot.max_yaw_rate_radps, state.yaw_rate_radps + most_turn);
  const double right = std::max(-robot.max_yaw_rate_radps, state.yaw_rate_radps - most_turn);
  const double way_m =
      std::max(0.5, options.lookahead_m *
                        std::min(1.0, std::abs(state.speed_mps) / robot.max_speed_mps + 0.5));
  const WorldPoint target = Ahead(plan.way(), way_m);
  const double here_cost = plan.CostAt(state.at);

  std::optional<DriveCommand> best;
  double best_score = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kSpeeds; ++i) {
    const double share = static_cast<double>(i) / (kSpeeds - 1);
    double speed = std::min(slowest, fastest) + share * (fastest - std::min(slowest, fastest));
    if (std::abs(speed) < 0.02) speed = 0.0;
    for (int k = 0; k < kYawRates; ++k) {
      const DriveCommand command{speed,
                                 right + (left - right) * static_cast<double>(k) / (kYawRates - 1)};
      if (!CanSteer(command, robot)) continue;
      const double stop_s = std::abs(speed) / robot.max_acceleration_mps2;
      const Arc arc = Drive(state, command, std::max(options.horizon_s, stop_s + 0.4), room);
      const bool touches = arc.least_room_m < 0.0;
      // Who stands too near something may go where there is more room.
      const bool frees = here_room_m < 0.02 && arc.last_room_m > here_room_m + 0.02 &&
                         arc.least_room_m > here_room_m - 0.02;
      if (touches && !frees) continue;
      double cost_m = plan.CostAt(arc.end.at);
      if (!std::isfinite(cost_m)) {
        if (!frees) continue;
        cost_m = std::isfinite(here_cost) ? here_cost + 1.0 : 0.0;
      }
      const double x_m = target.x_m - arc.end.at.x_m, y_m = target.y_m - arc.end.at.y_m;
      const double far_m = std::hypot(x_m, y_m);
      const double off_rad =
          far_m < 0.15 ? 0.0 : std::abs(Wrapped(std::atan2(y_m, x_m) - arc.end.heading_rad));
      double score = cost_m + 0.35 * std::min(1.0, far_m / 0.4) * off_rad + 0.6 * far_m;
      if (speed < 0.0) score += 0.5 + 0.5 * std::abs(speed);
      if (arc.least_room_m < 0.3) score += 0.5 * (0.3 - std::max(0.0, arc.least_room_m));
      score += 0.02 * std::abs(command.yaw_rate_radps - state.yaw_rate_radps);
      if (!(score < best_score)) continue;
      best_score = score;
      best = command;
    }
  }
  return best;
}

DriveCommand Approach(const DriveCommand& from, const DriveCommand& to, const NavigatorRobot& robot,
                      double period_s) {
  const double speed = robot.max_acceleration_mps2 * period_s;
  const double turn = robot.max_yaw_acceleration_radps2 * period_s;
  DriveCommand command{
      std::clamp(to.speed_mps, from.speed_mps - speed, from.speed_mps + speed),
      std::clamp(to.yaw_rate_radps, from.yaw_rate_radps - turn, from.yaw_rate_radps + turn)};
  if (robot.min_turn_radius_m > 0.0) {
    const double most = std::abs(command.speed_mps) / robot.min_turn_radius_m;
    command.yaw_rate_radps = std::clamp(command.yaw_rate_radps, -most, most);
  }
  return command;
}

}  // namespace latticeworld
