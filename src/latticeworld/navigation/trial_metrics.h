#ifndef LATTICEWORLD_NAVIGATION_TRIAL_METRICS_H_
#define LATTICEWORLD_NAVIGATION_TRIAL_METRICS_H_

#include <Eigen/Core>
#include <vector>

#include "latticeworld/common/status.h"

namespace latticeworld {

// Says where a robot was, and what it felt, at one moment.
struct TrialSample {
  double time_s = 0.0;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  // of base_link, map frame
  double yaw_rad = 0.0;
  double power_w = 0.0;  // that its motors give or take, summed as absolute values
  // The time until it and the nearest other body meet if both go on as they go; infinity: they do
  // not.
  double time_to_collision_s = 0.0;
};

// One try of a task.
struct TrialRecord {
  std::vector<TrialSample> samples;       // by time, strictly increasing
  std::vector<double> collision_times_s;  // at which physics contacts with what is not ground began
  int adversary_hits = 0;                 // blows that it took
  bool survived = true;
  bool timed_out = false;
};

// What a try is measured by.
struct TrialGoal {
  Eigen::Vector2d goal_m = Eigen::Vector2d::Zero();
  double radius_m = 0.5;       // of the goal, > 0
  double shortest_m = 0.0;     // geodesic length from the start to the goal, > 0
  double top_speed_mps = 1.0;  // of the robot, > 0
};

// docs/navigation.md has the formulas. Lengths are those of the robot's way in space.
struct TrialMetrics {
  bool success = false;          // survived, in time, and at the end within radius_m of the goal
  double goal_distance_m = 0.0;  // at the end, in plan
  double time_s = 0.0;
  double length_m = 0.0;
  double spl = 0.0;       // success weighted by path length: Anderson et al. 2018
  double sct = 0.0;       // by completion time: Yokoyama et al. 2021
  double barn_4_8 = 0.0;  // BARN's score as of its first challenge: Xiao et al. 2022
  double barn_2_8 = 0.0;  // as of the later ones: Xiao et al. 2023
  int collisions = 0;
  double collision_free_m = 0.0;           // of the way, before the first collision
  double least_time_to_collision_s = 0.0;  // infinity: never on a course to meet anything
  double path_irregularity_radpm = 0.0;    // turning beyond what a straight way needs: Guzzi 2013
  double mean_curvature_pm = 0.0;          // of the circle through three samples, by length
  double mean_jerk_mps3 = 0.0;             // of the third divided differences, by time
  double energy_j = 0.0;
  int adversary_hits = 0;
  bool survived = true;
  bool timed_out = false;
};

// Errors: INVALID_ARGUMENT with every violation (no sample, times that do not increase, numbers
// that are not finite, a goal that is none).
Status Validate(const TrialRecord& record, const TrialGoal& goal);

// record, goal: valid.
TrialMetrics Measure(const TrialRecord& record, const TrialGoal& goal);

// Returns the time until two discs touch that go on as they go [s]; 0: they already do; infinity:
// they never do. position, velocity: of the second as the first sees it; radii_m: sum of both.
double TimeToCollision(const Eigen::Vector2d& position_m, const Eigen::Vector2d& velocity_mps,
                       double radii_m);

// Sums up the metrics of many trials.
struct TrialSummary {
  int trials = 0;
  double success_share = 0.0;
  // Wilson's interval for the share at 95 % (Wilson 1927).
  double success_low = 0.0, success_high = 0.0;
  double mean_spl = 0.0, mean_sct = 0.0, mean_barn_4_8 = 0.0, mean_barn_2_8 = 0.0;
  double collision_share = 0.0, timeout_share = 0.0, survival_share = 0.0;
  double mean_collisions = 0.0, mean_adversary_hits = 0.0;
  // Means over the successful trials; 0: there is none.
  double mean_time_s = 0.0, mean_length_m = 0.0, mean_energy_j = 0.0;
};
TrialSummary Summarize(const std::vector<TrialMetrics>& trials);

}  // namespace latticeworld

#endif  // LATTICEWORLD_NAVIGATION_TRIAL_METRICS_H_
