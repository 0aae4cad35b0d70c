#include "latticeworld/navigation/trial_metrics.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <limits>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Samples of a way given by time, at steps that are not even.
TrialRecord Along(const std::function<Eigen::Vector3d(double)>& way, double duration_s,
                  std::uint64_t seed, double mean_step_s = 0.02) {
  RandomStream random(seed, "steps");
  TrialRecord record;
  double time_s = 0.0;
  while (true) {
    const double at_s = std::min(time_s, duration_s);
    const Eigen::Vector3d here = way(at_s), ahead = way(at_s + 1e-5) - way(at_s - 1e-5);
    record.samples.push_back({at_s, here, std::atan2(ahead.y(), ahead.x()), 0.0, kInfinity});
    if (at_s >= duration_s) return record;
    time_s += mean_step_s * random.Uniform(0.5, 1.5);
  }
}

TrialGoal GoalAt(double x, double y, double shortest_m, double top_speed_mps) {
  return {{x, y}, 0.5, shortest_m, top_speed_mps};
}

TEST(TrialMetrics, StraightAtTopSpeedIsPerfect) {
  const TrialRecord record =
      Along([](double t) { return Eigen::Vector3d(2.0 * t, 0.0, 0.0); }, 10.0, 1);
  const TrialMetrics metrics = Measure(record, GoalAt(20.0, 0.0, 20.0, 2.0));
  EXPECT_TRUE(metrics.success);
  EXPECT_NEAR(metrics.spl, 1.0, 1e-9);
  EXPECT_NEAR(metrics.sct, 1.0, 1e-9);
  EXPECT_NEAR(metrics.barn_4_8, 0.25, 1e-9);
  EXPECT_NEAR(metrics.barn_2_8, 0.5, 1e-9);
  EXPECT_NEAR(metrics.path_irregularity_radpm, 0.0, 1e-9);
  EXPECT_NEAR(metrics.mean_curvature_pm, 0.0, 1e-9);
  EXPECT_NEAR(metrics.mean_jerk_mps3, 0.0, 1e-4);
  EXPECT_EQ(metrics.collisions, 0);
  EXPECT_EQ(metrics.least_time_to_collision_s, kInfinity);
}

TEST(TrialMetrics, DetoursCostShareOfTheWayAndOfTheTime) {
  // Three sides of a square of ten metres, at 1 m/s, for a way of ten.
  const TrialRecord record = Along(
      [](double t) {
        if (t < 10.0) return Eigen::Vector3d(0.0, t, 0.0);
        if (t < 20.0) return Eigen::Vector3d(t - 10.0, 10.0, 0.0);
        return Eigen::Vector3d(10.0, 30.0 - t, 0.0);
      },
      30.0, 2, 0.001);
  const TrialMetrics metrics = Measure(record, GoalAt(10.0, 0.0, 10.0, 2.0));
  EXPECT_TRUE(metrics.success);
  EXPECT_NEAR(metrics.spl, 1.0 / 3.0, 1e-3);
  EXPECT_NEAR(metrics.sct, 5.0 / 30.0, 1e-9);
  // 30 s lie between 4 and 8 times the optimal 5 s.
  EXPECT_NEAR(metrics.barn_4_8, 5.0 / 30.0, 1e-9);
  EXPECT_NEAR(metrics.barn_2_8, 5.0 / 30.0, 1e-9);
  // It turns right twice by 90 degrees and needed one to turn towards the goal.
  EXPECT_NEAR(metrics.path_irregularity_radpm, (M_PI - M_PI / 2.0) / 30.0, 1e-3);
}

TEST(TrialMetrics, BarnClipsSlowTriesAtEightTimes) {
  const TrialRecord record =
      Along([](double t) { return Eigen::Vector3d(0.1 * t, 0.0, 0.0); }, 100.0, 3);
  const TrialMetrics metrics = Measure(record, GoalAt(10.0, 0.0, 10.0, 2.0));
  EXPECT_NEAR(metrics.barn_4_8, 1.0 / 8.0, 1e-9);
  EXPECT_NEAR(metrics.barn_2_8, 1.0 / 8.0, 1e-9);
}

TEST(TrialMetrics, WhatFailsScoresNothing) {
  TrialRecord record = Along([](double t) { return Eigen::Vector3d(t, 0.0, 0.0); }, 10.0, 4);
  const TrialGoal goal = GoalAt(10.0, 0.0, 10.0, 1.0);
  ASSERT_TRUE(Measure(record, goal).success);
  const auto expect_nothing = [&](const TrialRecord& failed, const TrialGoal& wanted) {
    const TrialMetrics metrics = Measure(failed, wanted);
    EXPECT_FALSE(metrics.success);
    EXPECT_EQ(metrics.spl + metrics.sct + metrics.barn_2_8 + metrics.barn_4_8, 0.0);
  };
  expect_nothing(record, GoalAt(10.6, 0.0, 10.6, 1.0));
  TrialRecord late = record;
  late.timed_out = true;
  expect_nothing(late, goal);
  TrialRecord dead = record;
  dead.survived = false;
  expect_nothing(dead, goal);
}

TEST(TrialMetrics, CurvatureOfACircleIsOneByItsRadius) {
  for (const double radius : {0.7, 3.0, 12.0}) {
    const TrialRecord record = Along(
        [&](double t) { return Eigen::Vector3d(radius * std::cos(t), radius * std::sin(t), 1.0); },
        6.0, 5, 0.01);
    EXPECT_NEAR(Measure(record, GoalAt(0.0, 0.0, 1.0, 1.0)).mean_curvature_pm, 1.0 / radius,
                1e-3 / radius);
  }
}

TEST(TrialMetrics, JerkOfACubicIsExactWhateverTheSteps) {
  const TrialRecord record =
      Along([](double t) { return Eigen::Vector3d(t * t * t / 6.0, 0.0, t * t * t / 3.0); }, 3.0, 6,
            0.05);
  EXPECT_NEAR(Measure(record, GoalAt(0.0, 0.0, 1.0, 1.0)).mean_jerk_mps3, std::sqrt(5.0), 1e-6);
}

TEST(TrialMetrics, AreTheSameWhereverTheWorldIsPut) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomStream random(seed, "motion");
    const double a = random.Uniform(0.2, 1.0), b = random.Uniform(0.5, 2.0);
    const double angle = random.Uniform(-3.0, 3.0);
    const Eigen::Vector3d shift(random.Uniform(-50.0, 50.0), random.Uniform(-50.0, 50.0), 3.0);
    const auto way = [&](double t) { return Eigen::Vector3d(t, a * std::sin(b * t), 0.1 * t); };
    const Eigen::AngleAxisd turn(angle, Eigen::Vector3d::UnitZ());
    const TrialRecord here = Along(way, 12.0, seed);
    const TrialRecord there =
        Along([&](double t) -> Eigen::Vector3d { return turn * way(t) + shift; }, 12.0, seed);
    const Eigen::Vector3d goal = way(12.0), moved = turn * goal + shift;
    const TrialMetrics x = Measure(here, GoalAt(goal.x(), goal.y(), 11.0, 2.0));
    const TrialMetrics y = Measure(there, GoalAt(moved.x(), moved.y(), 11.0, 2.0));
    EXPECT_NEAR(x.spl, y.spl, 1e-9);
    EXPECT_NEAR(x.mean_curvature_pm, y.mean_curvature_pm, 1e-6);
    EXPECT_NEAR(x.path_irregularity_radpm, y.path_irregularity_radpm, 1e-4);
    EXPECT_NEAR(x.mean_jerk_mps3, y.mean_jerk_mps3, 1e-4);
    EXPECT_LE(x.spl, 1.0);
    EXPECT_LE(x.barn_4_8, x.barn_2_8);
  }
}

TEST(TrialMetrics, CountsCollisionsHitsAndEnergy) {
  TrialRecord record = Along([](double t) { return Eigen::Vector3d(t, 0.0, 0.0); }, 10.0, 7);
  for (TrialSample& sample : record.samples) sample.power_w = 20.0;
  record.samples[40].time_to_collision_s = 0.4;
  record.collision_times_s = {7.0, 4.0};
  record.adversary_hits = 3;
  const TrialMetrics metrics = Measure(record, GoalAt(10.0, 0.0, 10.0, 1.0));
  EXPECT_TRUE(metrics.success);
  EXPECT_EQ(metrics.collisions, 2);
  EXPECT_NEAR(metrics.collision_free_m, 4.0, 0.03);
  EXPECT_NEAR(metrics.energy_j, 200.0, 1e-6);
  EXPECT_EQ(metrics.adversary_hits, 3);
  EXPECT_DOUBLE_EQ(metrics.least_time_to_collision_s, 0.4);
}

TEST(TimeToCollision, IsThatOfTwoDiscs) {
  EXPECT_DOUBLE_EQ(TimeToCollision({10.0, 0.0}, {-2.0, 0.0}, 1.0), 4.5);
  EXPECT_EQ(TimeToCollision({10.0, 0.0}, {2.0, 0.0}, 1.0), kInfinity);
  EXPECT_EQ(TimeToCollision({10.0, 3.0}, {-2.0, 0.0}, 1.0), kInfinity);
  EXPECT_EQ(TimeToCollision({0.5, 0.0}, {0.0, 0.0}, 1.0), 0.0);
  EXPECT_EQ(TimeToCollision({5.0, 0.0}, {0.0, 0.0}, 1.0), kInfinity);
}

TEST(TrialSummary, HasWilsonsInterval) {
  std::vector<TrialMetrics> trials(10);
  for (int i = 0; i < 8; ++i) {
    trials[i].success = true;
    trials[i].spl = 0.5;
    trials[i].time_s = 3.0;
  }
  const TrialSummary summary = Summarize(trials);
  EXPECT_DOUBLE_EQ(summary.success_share, 0.8);
  // Worked out by hand for 8 of 10.
  EXPECT_NEAR(summary.success_low, 0.4902, 1e-4);
  EXPECT_NEAR(summary.success_high, 0.9433, 1e-4);
  EXPECT_DOUBLE_EQ(summary.mean_spl, 0.4);
  EXPECT_DOUBLE_EQ(summary.mean_time_s, 3.0);
  EXPECT_EQ(Summarize({}).trials, 0);
}

TEST(TrialMetrics, ValidationTellsEveryFault) {
  TrialRecord record;
  record.samples = {{1.0, {0, 0, 0}, 0.0, 0.0, 0.0}, {1.0, {0, 0, 0}, 0.0, 0.0, 0.0}};
  record.samples[1].position_m.x() = std::nan("");
  TrialGoal goal = GoalAt(0.0, 0.0, 0.0, -1.0);
  const Status status = Validate(record, goal);
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(status.violations().size(), 4u);
  EXPECT_FALSE(Validate(TrialRecord(), GoalAt(0.0, 0.0, 1.0, 1.0)).ok());
}

}  // namespace
}  // namespace latticeworld
