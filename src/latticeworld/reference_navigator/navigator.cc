#include "latticeworld/reference_navigator/navigator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/reference_navigator/controller.h"
#include "latticeworld/reference_navigator/global_route.h"
#include "latticeworld/reference_navigator/local_plan.h"
#include "latticeworld/reference_navigator/obstacle_layer.h"
#include "latticeworld/reference_navigator/slopes_of_map.h"

namespace latticeworld {
namespace {

constexpr double kDetour_m = 4.0;       // more than the global plan expects: it has to know why
constexpr double kReplanPause_s = 2.0;  // between two global plans at least
constexpr double kWayPause_s = 1.0;     // between two ways that are shown
constexpr double kProgress_m = 0.25;
constexpr double kMoved_m = 0.1;  // less is no progress, whatever is seen meanwhile
constexpr double kRecovery_s = 2.5;

double HeadingOf(const Eigen::Isometry3d& pose) {
  return std::atan2(pose.linear()(1, 0), pose.linear()(0, 0));
}

}  // namespace

class Navigator::Impl {
 public:
  explicit Impl(const NavigatorOptions& options)
      : options_(options), route_(options), seen_(options) {}

  void SetMap(CostMap map) {
    route_.SetMap(std::move(map));
    wants_plan_ = true;
  }

  Status SetGoal(WorldPoint goal, std::optional<double> heading_rad, const NavigatorPose& pose) {
    if (!std::isfinite(goal.x_m) || !std::isfinite(goal.y_m) ||
        (heading_rad && !std::isfinite(*heading_rad)) || !pose.map_from_base.matrix().allFinite())
      return InvalidArgument("the goal and the pose have to be finite numbers");
    if (!route_.has_map()) return FailedPrecondition("there is no map yet");
    LW_RETURN_IF_ERROR(route_.SetGoal(
        goal, {pose.map_from_base.translation().x(), pose.map_from_base.translation().y()}));
    goal_heading_rad_ = heading_rad;
    state_ = NavigatorState::kFollowing;
    why_ = Status();
    wants_plan_ = false;
    begun_s_ = pose.time_s;
    recoveries_ = 0;
    nearest_cost_m_ = std::numeric_limits<double>::infinity();
    last_plan_s_ = pose.time_s - kReplanPause_s;
    last_way_s_ = -1e300;
    ForgetProgress(pose.time_s);
    return Status();
  }

  void Cancel() {
    state_ = NavigatorState::kIdle;
    why_ = Status();
    way_.reset();
  }

  void See(const SensorSighting& sighting) {
    if (!std::isfinite(sighting.time_s) || !sighting.map_from_sensor.matrix().allFinite()) return;
    const SlopesOfMap slopes(route_.map(), options_.robot.max_slope_rad);
    seen_.See(sighting, route_.has_map() ? &slopes : nullptr);
  }
  void Forget() { seen_.Forget(); }

  NavigatorOutput Update(const NavigatorPose& pose) {
    if (!std::isfinite(pose.time_s) || !pose.map_from_base.matrix().allFinite() ||
        !std::isfinite(pose.speed_mps) || !std::isfinite(pose.yaw_rate_radps))
      return Output({});
    const double period_s = std::clamp(pose.time_s - last_s_, 0.02, 0.5);
    last_s_ = pose.time_s;
    seen_.MoveTo(pose.map_from_base.translation());
    if (state_ != NavigatorState::kFollowing && state_ != NavigatorState::kRecovering)
      return Output({});
    seen_.Settle(pose.time_s);
    PlanarState at;
    at.at = {pose.map_from_base.translation().x(), pose.map_from_base.translation().y()};
    at.heading_rad = HeadingOf(pose.map_from_base);
    at.speed_mps = pose.speed_mps;
    at.yaw_rate_radps = pose.yaw_rate_radps;
    const DriveCommand wanted = Drive(at, pose.time_s, period_s);
    if (state_ != NavigatorState::kFollowing && state_ != NavigatorState::kRecovering)
      return Output({});
    return Output(Approach({at.speed_mps, at.yaw_rate_radps}, wanted, options_.robot,
                           std::max(period_s, 0.3)));
  }

  Result<std::vector<WorldPoint>> Plan(WorldPoint start, WorldPoint goal,
                                       double tolerance_m) const {
    if (!std::isfinite(start.x_m) || !std::isfinite(start.y_m) || !std::isfinite(goal.x_m) ||
        !std::isfinite(goal.y_m) || !(tolerance_m >= 0.0))
      return InvalidArgument("start, goal and tolerance have to be finite numbers");
    return route_.Plan(start, goal, tolerance_m);
  }

 private:
  NavigatorOutput Output(const DriveCommand& command) const {
    NavigatorOutput output;
    output.state = state_;
    output.speed_mps = command.speed_mps;
    output.yaw_rate_radps = command.yaw_rate_radps;
    output.why = why_;
    output.way_left_m = way_left_m_;
    output.way = way_;
    return output;
  }

  void ForgetProgress(double time_s) {
    least_cost_m_ = std::numeric_limits<double>::infinity();
    progress_s_ = time_s;
  }

  void Fail(Status why) {
    state_ = NavigatorState::kFailed;
    why_ = std::move(why);
    way_.reset();
    way_left_m_ = 0.0;
  }

  void PlanAnew(WorldPoint here, double time_s) {
    route_.PlanAnew(here, seen_);
    last_plan_s_ = time_s;
    last_way_s_ = -1e300;
    wants_plan_ = false;
  }

  void ShowWay(const LocalPlan& local, WorldPoint here, double time_s) {
    if (time_s - last_way_s_ < kWayPause_s) return;
    last_way_s_ = time_s;
    std::vector<WorldPoint> way = local.way();
    if (way.empty()) return;
    const WorldPoint end = way.back();
    if (std::hypot(end.x_m - route_.goal().x_m, end.y_m - route_.goal().y_m) > 0.1 &&
        std::isfinite(route_.CostFrom(end))) {
      const auto rest = route_.WayFrom(end);
      way.insert(way.end(), rest.begin() + 1, rest.end());
    }
    way.front() = here;
    way_left_m_ = 0.0;
    for (std::size_t i = 1; i < way.size(); ++i)
      way_left_m_ += std::hypot(way[i].x_m - way[i - 1].x_m, way[i].y_m - way[i - 1].y_m);
    way_ = std::make_shared<const std::vector<WorldPoint>>(std::move(way));
  }

  // Whether it is at the goal; *command: what to do to stand there as wanted.
  bool IsAtGoal(const PlanarState& at, DriveCommand* command) {
    const double far_m = std::hypot(at.at.x_m - route_.goal().x_m, at.at.y_m - route_.goal().y_m);
    // Once near enough it stays so while it turns and stops.
    const double near_m = options_.goal_radius_m * (is_near_ ? 0.95 : 0.7);
    is_near_ = far_m <= near_m;
    if (!is_near_) return false;
    *command = {};
    if (goal_heading_rad_ && std::isfinite(options_.goal_heading_tolerance_rad) &&
        options_.robot.min_turn_radius_m <= 0.0) {
      const double off_rad = std::remainder(*goal_heading_rad_ - at.heading_rad, 2.0 * M_PI);
      if (std::abs(off_rad) > 0.7 * options_.goal_heading_tolerance_rad) {
        command->yaw_rate_radps = std::clamp(1.5 * off_rad, -options_.robot.max_yaw_rate_radps,
                                             options_.robot.max_yaw_rate_radps);
        return true;
      }
    }
    if (std::abs(at.speed_mps) < 0.05 && std::abs(at.yaw_rate_radps) < 0.1) {
      state_ = NavigatorState::kArrived;
      way_left_m_ = 0.0;
    }
    return true;
  }

  DriveCommand Drive(const PlanarState& at, double time_s, double period_s) {
    if (time_s - begun_s_ > options_.time_limit_s) {
      Fail(Status(StatusCode::kDeadlineExceeded,
                  "the goal was not reached within " + FormatDouble(options_.time_limit_s) + " s"));
      return {};
    }
    // At the goal it stands; off the map it fails.
    DriveCommand stand;
    if (IsAtGoal(at, &stand)) return stand;
    if (!route_.map().geometry.Contains(at.at)) {
      Fail(Status(StatusCode::kOutOfRange, "the robot left the map at " + Shown(at.at)));
      return {};
    }
    // It plans when it is told to, or when the local way costs much more than expected.
    if (wants_plan_) {
      PlanAnew(at.at, time_s);
      ForgetProgress(time_s);
    }
    LocalPlan local(route_.plan(), seen_, options_, at.at);
    double cost_m = local.CostAt(at.at);
    const double expected_m = route_.CostFrom(at.at);
    if ((!std::isfinite(cost_m) || cost_m > expected_m + kDetour_m || !std::isfinite(expected_m)) &&
        time_s - last_plan_s_ >= kReplanPause_s) {
      PlanAnew(at.at, time_s);
      local = LocalPlan(route_.plan(), seen_, options_, at.at);
      cost_m = local.CostAt(at.at);
      // A longer way is no step back, but neither is a shorter one progress until it is gone.
      if (std::isfinite(cost_m)) least_cost_m_ = cost_m;
    }
    // It makes progress if the rest of the way shrinks while it moves.
    const double moved_m = std::hypot(at.at.x_m - progress_at_.x_m, at.at.y_m - progress_at_.y_m);
    if (cost_m < least_cost_m_ - kProgress_m && moved_m > kMoved_m) {
      least_cost_m_ = cost_m;
      progress_s_ = time_s;
      progress_at_ = at.at;
    }
    // What counts as free again is nearer to the goal than it ever was: a robot that comes back to
    // where it was stuck is as stuck as before.
    if (cost_m < nearest_cost_m_ - 4.0 * kProgress_m) {
      nearest_cost_m_ = cost_m;
      recoveries_ = 0;
    }
    ShowWay(local, at.at, time_s);
    // Without progress it tries to free itself for a while.
    if (state_ == NavigatorState::kRecovering) {
      if (time_s - recovering_s_ < kRecovery_s) return Free(at);
      state_ = NavigatorState::kFollowing;
      ForgetProgress(time_s);
    }
    if (time_s - progress_s_ > options_.patience_s) return BeginRecovery(at, cost_m, time_s);
    // Else it follows the way, slower the nearer the goal is.
    const double far_m = std::hypot(at.at.x_m - route_.goal().x_m, at.at.y_m - route_.goal().y_m);
    const double top_speed =
        std::max(0.1, std::sqrt(1.2 * options_.robot.max_acceleration_mps2 * far_m));
    return ChooseArc(at, local, seen_, route_.plan(), options_, period_s, top_speed)
        .value_or(DriveCommand{});
  }

  DriveCommand BeginRecovery(const PlanarState& at, double cost_m, double time_s) {
    if (++recoveries_ > options_.recoveries) {
      Fail(std::isfinite(cost_m)
               ? Status(StatusCode::kAborted,
                        "the robot is stuck at " + Shown(at.at) + ": it makes no way for " +
                            FormatDouble(options_.patience_s) + " s, and " +
                            std::to_string(options_.recoveries) + " tries to free it failed")
               : NotFound("what is seen around " + Shown(at.at) + " closes every way to the goal " +
                          Shown(route_.goal())));
      return {};
    }
    state_ = NavigatorState::kRecovering;
    recovering_s_ = time_s;
    seen_.Forget();
    if (!std::isfinite(cost_m)) {
      route_.OpenAgain();
      last_plan_s_ = time_s;
      last_way_s_ = -1e300;
    }
    return Free(at);
  }

  // Backward in a bend where there is room, else around on the spot, else forward.
  DriveCommand Free(const PlanarState& at) const {
    const NavigatorRobot& robot = options_.robot;
    const double side = recoveries_ % 2 == 0 ? 1.0 : -1.0;
    const auto is_open = [&](double direction) {
      const WorldPoint there{at.at.x_m + direction * 0.5 * std::cos(at.heading_rad),
                             at.at.y_m + direction * 0.5 * std::sin(at.heading_rad)};
      return route_.IsOpenOnMap(there) && seen_.DistanceAt(there) > robot.radius_m;
    };
    const double back = 0.7 * robot.max_reverse_mps;
    const double turn = robot.min_turn_radius_m > 0.0
                            ? back / std::max(robot.min_turn_radius_m, 0.1)
                            : 0.4 * robot.max_yaw_rate_radps;
    if (back > 0.0 && is_open(-1.0)) return {-back, side * turn};
    if (robot.min_turn_radius_m <= 0.0) return {0.0, side * 0.6 * robot.max_yaw_rate_radps};
    if (is_open(1.0)) return {0.3 * robot.max_speed_mps, side * turn};
    return {};
  }

  const NavigatorOptions options_;
  GlobalRoute route_;
  ObstacleLayer seen_;

  NavigatorState state_ = NavigatorState::kIdle;
  Status why_;
  std::optional<double> goal_heading_rad_;
  bool wants_plan_ = false;
  bool is_near_ = false;
  double last_s_ = 0.0, begun_s_ = 0.0, last_plan_s_ = 0.0, last_way_s_ = 0.0;
  double nearest_cost_m_ = 0.0;  // of the way to go, ever since the goal was set
  double least_cost_m_ = 0.0, progress_s_ = 0.0, recovering_s_ = 0.0;
  WorldPoint progress_at_;
  int recoveries_ = 0;  // without progress between them
  double way_left_m_ = 0.0;
  std::shared_ptr<const std::vector<WorldPoint>> way_;
};

Navigator::Navigator(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Navigator::~Navigator() = default;

Result<std::unique_ptr<Navigator>> Navigator::Create(const NavigatorOptions& options) {
  LW_RETURN_IF_ERROR(Status::FromViolations("navigator options", Validate(options)));
  return std::unique_ptr<Navigator>(new Navigator(std::make_unique<Impl>(options)));
}

void Navigator::SetMap(CostMap map) { impl_->SetMap(std::move(map)); }
Status Navigator::SetGoal(WorldPoint goal, std::optional<double> heading_rad,
                          const NavigatorPose& pose) {
  return impl_->SetGoal(goal, heading_rad, pose);
}
void Navigator::Cancel() { impl_->Cancel(); }
void Navigator::See(const SensorSighting& sighting) { impl_->See(sighting); }
void Navigator::Forget() { impl_->Forget(); }
NavigatorOutput Navigator::Update(const NavigatorPose& pose) { return impl_->Update(pose); }
Result<std::vector<WorldPoint>> Navigator::Plan(WorldPoint start, WorldPoint goal,
                                                double tolerance_m) const {
  return impl_->Plan(start, goal, tolerance_m);
}

}  // namespace latticeworld
