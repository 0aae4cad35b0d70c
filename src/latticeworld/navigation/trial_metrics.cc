#include "latticeworld/navigation/trial_metrics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double Turn(double from_rad, double to_rad) {
  return std::abs(std::remainder(to_rad - from_rad, 2.0 * M_PI));
}

// Score of the Benchmark for Autonomous Robot Navigation, with the optimal time that goes by the
// top speed over the shortest way.
double BarnScore(const TrialMetrics& metrics, double optimal_s, double low, double high) {
  if (!metrics.success) return 0.0;
  return optimal_s / std::clamp(metrics.time_s, low * optimal_s, high * optimal_s);
}

// All turning less that of turning towards the goal at the start and going straight, by length.
double PathIrregularity(const TrialRecord& record, const TrialGoal& goal, double length_m) {
  if (length_m <= 0.0) return 0.0;
  double turned_rad = 0.0;
  for (std::size_t i = 1; i < record.samples.size(); ++i)
    turned_rad += Turn(record.samples[i - 1].yaw_rad, record.samples[i].yaw_rad);
  const TrialSample& first = record.samples.front();
  const Eigen::Vector2d to_goal = goal.goal_m - first.position_m.head<2>();
  const double needed_rad =
      to_goal.norm() > 1e-9 ? Turn(first.yaw_rad, std::atan2(to_goal.y(), to_goal.x())) : 0.0;
  return std::max(0.0, turned_rad - needed_rad) / length_m;
}

// Curvature of the circle through three places: four times the triangle's area by the product of
// its sides (Menger).
double MeanCurvature(const std::vector<TrialSample>& samples) {
  // Standing still has no direction: only places some way apart count.
  constexpr double kApart_m = 0.02;
  std::vector<Eigen::Vector3d> places;
  for (const TrialSample& sample : samples) {
    if (places.empty() || (sample.position_m - places.back()).norm() >= kApart_m)
      places.push_back(sample.position_m);
  }
  double sum = 0.0, length_m = 0.0;
  for (std::size_t i = 2; i < places.size(); ++i) {
    const Eigen::Vector3d a = places[i - 1] - places[i - 2], b = places[i] - places[i - 1];
    const Eigen::Vector3d c = places[i] - places[i - 2];
    const double here_m = 0.5 * (a.norm() + b.norm());
    // There and straight back again: as sharp as the places are apart.
    const double curvature_pm =
        c.norm() < 1e-9 ? 2.0 / here_m : 2.0 * a.cross(b).norm() / (a.norm() * b.norm() * c.norm());
    sum += curvature_pm * here_m;
    length_m += here_m;
  }
  return length_m > 0.0 ? sum / length_m : 0.0;
}

// Six times the third divided difference of position, which knows steps that are not even.
double MeanJerk(const std::vector<TrialSample>& samples) {
  double sum = 0.0, time_s = 0.0;
  for (std::size_t i = 3; i < samples.size(); ++i) {
    const TrialSample* s = &samples[i - 3];
    Eigen::Vector3d difference[4];
    for (int k = 0; k < 4; ++k) difference[k] = s[k].position_m;
    for (int order = 1; order <= 3; ++order) {
      for (int k = 0; k + order < 4; ++k)
        difference[k] = (difference[k + 1] - difference[k]) / (s[k + order].time_s - s[k].time_s);
    }
    const double span_s = s[2].time_s - s[1].time_s;
    sum += 6.0 * difference[0].norm() * span_s;
    time_s += span_s;
  }
  return time_s > 0.0 ? sum / time_s : 0.0;
}

}  // namespace

Status Validate(const TrialRecord& record, const TrialGoal& goal) {
  std::vector<Violation> violations;
  const auto add = [&](std::string pointer, std::string message, std::string given) {
    violations.push_back(
        {"out_of_range", std::move(pointer), std::move(message), std::move(given)});
  };
  if (record.samples.empty()) add("/samples", "must hold at least one sample", "0");
  for (std::size_t i = 0; i < record.samples.size(); ++i) {
    const TrialSample& sample = record.samples[i];
    const std::string pointer = "/samples/" + std::to_string(i);
    if (!std::isfinite(sample.time_s) || !sample.position_m.allFinite() ||
        !std::isfinite(sample.yaw_rad) || !std::isfinite(sample.power_w))
      add(pointer, "must be finite numbers", "not finite");
    if (i > 0 && !(sample.time_s > record.samples[i - 1].time_s))
      add(pointer + "/time_s", "must be above the sample's before", FormatDouble(sample.time_s));
  }
  const auto positive = [&](const char* pointer, double value) {
    if (!(value > 0.0) || !std::isfinite(value))
      add(pointer, "must be above 0 and finite", FormatDouble(value));
  };
  if (!goal.goal_m.allFinite()) add("/goal", "must be finite numbers", "not finite");
  positive("/radius_m", goal.radius_m);
  positive("/shortest_m", goal.shortest_m);
  positive("/top_speed_mps", goal.top_speed_mps);
  if (violations.empty()) return Status();
  return Status::FromViolations("a trial", std::move(violations));
}

TrialMetrics Measure(const TrialRecord& record, const TrialGoal& goal) {
  TrialMetrics metrics;
  const std::vector<TrialSample>& samples = record.samples;
  metrics.goal_distance_m = (samples.back().position_m.head<2>() - goal.goal_m).norm();
  metrics.time_s = samples.back().time_s - samples.front().time_s;
  metrics.survived = record.survived;
  metrics.timed_out = record.timed_out;
  metrics.adversary_hits = record.adversary_hits;
  metrics.collisions = static_cast<int>(record.collision_times_s.size());
  const double first_collision_s =
      record.collision_times_s.empty()
          ? kInfinity
          : *std::min_element(record.collision_times_s.begin(), record.collision_times_s.end());
  metrics.least_time_to_collision_s = samples.front().time_to_collision_s;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const TrialSample &before = samples[i - 1], &after = samples[i];
    const double step_m = (after.position_m - before.position_m).norm();
    metrics.length_m += step_m;
    if (after.time_s <= first_collision_s) metrics.collision_free_m += step_m;
    metrics.energy_j += 0.5 * (before.power_w + after.power_w) * (after.time_s - before.time_s);
    metrics.least_time_to_collision_s =
        std::min(metrics.least_time_to_collision_s, after.time_to_collision_s);
  }
  metrics.success =
      record.survived && !record.timed_out && metrics.goal_distance_m <= goal.radius_m;
  if (metrics.success) {
    const double optimal_s = goal.shortest_m / goal.top_speed_mps;
    metrics.spl = goal.shortest_m / std::max(metrics.length_m, goal.shortest_m);
    metrics.sct = optimal_s / std::max(metrics.time_s, optimal_s);
    metrics.barn_4_8 = BarnScore(metrics, optimal_s, 4.0, 8.0);
    metrics.barn_2_8 = BarnScore(metrics, optimal_s, 2.0, 8.0);
  }
  metrics.path_irregularity_radpm = PathIrregularity(record, goal, metrics.length_m);
  metrics.mean_curvature_pm = MeanCurvature(samples);
  metrics.mean_jerk_mps3 = MeanJerk(samples);
  return metrics;
}

double TimeToCollision(const Eigen::Vector2d& position_m, const Eigen::Vector2d& velocity_mps,
                       double radii_m) {
  const double apart = position_m.squaredNorm() - radii_m * radii_m;
  if (apart <= 0.0) return 0.0;
  const double closing = -position_m.dot(velocity_mps);
  const double speed = velocity_mps.squaredNorm();
  const double root = closing * closing - speed * apart;
  if (closing <= 0.0 || root < 0.0) return kInfinity;
  // The sooner of the two, in the form that does not cancel.
  return apart / (closing + std::sqrt(root));
}

TrialSummary Summarize(const std::vector<TrialMetrics>& trials) {
  TrialSummary summary;
  summary.trials = static_cast<int>(trials.size());
  if (trials.empty()) return summary;
  // Sums are taken over all trials, and over the successful ones.
  int successes = 0;
  for (const TrialMetrics& trial : trials) {
    summary.mean_spl += trial.spl;
    summary.mean_sct += trial.sct;
    summary.mean_barn_4_8 += trial.barn_4_8;
    summary.mean_barn_2_8 += trial.barn_2_8;
    summary.collision_share += trial.collisions > 0 ? 1.0 : 0.0;
    summary.timeout_share += trial.timed_out ? 1.0 : 0.0;
    summary.survival_share += trial.survived ? 1.0 : 0.0;
    summary.mean_collisions += trial.collisions;
    summary.mean_adversary_hits += trial.adversary_hits;
    if (!trial.success) continue;
    ++successes;
    summary.mean_time_s += trial.time_s;
    summary.mean_length_m += trial.length_m;
    summary.mean_energy_j += trial.energy_j;
  }
  // The sums become means.
  const double n = summary.trials;
  for (double* mean :
       {&summary.mean_spl, &summary.mean_sct, &summary.mean_barn_4_8, &summary.mean_barn_2_8,
        &summary.collision_share, &summary.timeout_share, &summary.survival_share,
        &summary.mean_collisions, &summary.mean_adversary_hits})
    *mean /= n;
  if (successes > 0) {
    for (double* mean : {&summary.mean_time_s, &summary.mean_length_m, &summary.mean_energy_j})
      *mean /= successes;
  }
  // Wilson's interval holds the share of success at 95 %.
  const double share = successes / n;
  summary.success_share = share;
  constexpr double kZ = 1.959963984540054;
  const double middle = (share + kZ * kZ / (2.0 * n)) / (1.0 + kZ * kZ / n);
  const double half =
      kZ / (1.0 + kZ * kZ / n) * std::sqrt(share * (1.0 - share) / n + kZ * kZ / (4.0 * n * n));
  summary.success_low = std::max(0.0, middle - half);
  summary.success_high = std::min(1.0, middle + half);
  return summary;
}

}  // namespace latticeworld
