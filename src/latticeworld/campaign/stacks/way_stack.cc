#include "latticeworld/campaign/stacks/way_stack.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace latticeworld {
namespace {

constexpr double kLookahead_m = 0.6;
constexpr double kTurnOnTheSpot_rad = 0.8;  // beyond this bearing it turns before it goes
constexpr double kArrivedShare = 0.6;       // of the goal's radius

class WayStack final : public RobotStack {
 public:
  bool UsesScans() const override { return false; }

  Status Begin(const StackTask& task, const StackInput&) override {
    way_m_ = task.task.way.points_m;
    if (way_m_.empty()) return FailedPrecondition("the task has no way");
    top_speed_mps_ = std::min(task.robot.top_speed_mps, task.species.top_speed_mps);
    turn_rate_radps_ = 0.7 * task.species.turn_rate_radps;
    arrived_m_ = kArrivedShare * task.task.goal_radius_m;
    done_ = 0;
    return Status();
  }

  StackOutput Update(const StackInput& input) override {
    StackOutput output;
    const Eigen::Vector2d here = input.map_from_base.translation().head<2>();
    const Eigen::Vector2d goal = way_m_.back().head<2>();
    const double left_m = (goal - here).norm();
    if (left_m <= arrived_m_) {
      output.state = StackState::kArrived;
      return output;
    }
    const Eigen::Vector2d ahead = Ahead(here) - here;
    const Eigen::Vector3d forward = input.map_from_base.linear().col(0);
    const double bearing = std::remainder(
        std::atan2(ahead.y(), ahead.x()) - std::atan2(forward.y(), forward.x()), 2.0 * M_PI);
    if (std::abs(bearing) > kTurnOnTheSpot_rad) {
      output.yaw_rate_radps = std::copysign(turn_rate_radps_, bearing);
      return output;
    }
    output.speed_mps =
        std::min(top_speed_mps_ * (1.0 - std::abs(bearing)), std::max(0.15, 0.8 * left_m));
    const double curvature = 2.0 * std::sin(bearing) / std::max(ahead.norm(), 0.2);
    output.yaw_rate_radps =
        std::clamp(output.speed_mps * curvature, -turn_rate_radps_, turn_rate_radps_);
    return output;
  }

 private:
  // The place on the way kLookahead_m beyond the nearest one; what lies behind stays behind.
  Eigen::Vector2d Ahead(const Eigen::Vector2d& here) {
    double best_m = std::numeric_limits<double>::infinity();
    std::size_t best = done_;
    double best_share = 0.0;
    double gone_m = 0.0;
    for (std::size_t i = done_; i + 1 < way_m_.size() && gone_m < 3.0; ++i) {
      const Eigen::Vector2d from = way_m_[i].head<2>(), leg = way_m_[i + 1].head<2>() - from;
      const double length_m = std::max(leg.norm(), 1e-9);
      const double share = std::clamp((here - from).dot(leg) / (length_m * length_m), 0.0, 1.0);
      const double distance_m = (from + share * leg - here).norm();
      if (distance_m < best_m) {
        best_m = distance_m;
        best = i;
        best_share = share;
      }
      gone_m += length_m;
    }
    done_ = best;
    double left_m = kLookahead_m;
    for (std::size_t i = best; i + 1 < way_m_.size(); ++i) {
      const Eigen::Vector2d from = way_m_[i].head<2>(), leg = way_m_[i + 1].head<2>() - from;
      const double length_m = leg.norm(), rest_m = (1.0 - best_share) * length_m;
      if (rest_m >= left_m) return from + (best_share + left_m / length_m) * leg;
      left_m -= rest_m;
      best_share = 0.0;
    }
    return way_m_.back().head<2>();
  }

  std::vector<Eigen::Vector3d> way_m_;
  std::size_t done_ = 0;  // leg that it is on
  double top_speed_mps_ = 1.0, turn_rate_radps_ = 1.0, arrived_m_ = 0.3;
};

}  // namespace

std::unique_ptr<RobotStack> MakeWayStack() { return std::make_unique<WayStack>(); }

}  // namespace latticeworld
