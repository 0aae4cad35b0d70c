#include "latticeworld/campaign/trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/campaign/stacks/way_stack.h"
#include "latticeworld/campaign/trial_result.h"
#include "latticeworld/mapping/traversability.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

// Does what it is told, step by step.
class FakeStack final : public RobotStack {
 public:
  using Decide = std::function<StackOutput(const StackInput&)>;
  explicit FakeStack(Decide decide) : decide_(std::move(decide)) {}
  bool UsesScans() const override { return true; }
  Status Begin(const StackTask&, const StackInput&) override { return begins; }
  StackOutput Update(const StackInput& input) override { return decide_(input); }
  Status begins;

 private:
  Decide decide_;
};

// From the west to the east of a level world of 64 m, 20 m along y = 0.
struct Course {
  CampaignRobot robot;
  CampaignCondition condition;
  NavigationTask task;
  TestScene scene;
  Grid<std::int8_t> occupancy;

  Course() {
    condition.seeds = {1};
    task.start = {-10.0, 0.0};
    task.goal = {10.0, 0.0};
    task.difficulty.length_m = 20.0;
    task.way.points_m = {{-10.0, 0.0, 0.0}, {10.0, 0.0, 0.0}};
    task.way.length_m = 20.0;
  }
  Result<TrialOutcome> Run(RobotStack* stack, std::uint64_t seed = 1) {
    const auto built = scene.Build();
    occupancy = BuildOccupancy(*built, robot.limits);
    return RunTrial({built, robot, condition, task, occupancy, seed, 0.01, 10.0}, stack);
  }
};

StackOutput Ahead(double speed_mps) {
  StackOutput output;
  output.speed_mps = speed_mps;
  return output;
}

TEST(TrialTest, TheWayAloneLeadsToTheGoalOnOpenGround) {
  Course course;
  const auto outcome = course.Run(MakeWayStack().get());
  ASSERT_TRUE(outcome.ok()) << outcome.status().ToString();
  EXPECT_EQ(outcome->ended_by, "arrived") << outcome->why;
  EXPECT_TRUE(outcome->metrics.success);
  EXPECT_GT(outcome->metrics.spl, 0.95);
  EXPECT_EQ(outcome->metrics.collisions, 0);
  EXPECT_GT(outcome->metrics.energy_j, 0.0);
  // Samples at the control's rate.
  const auto& samples = outcome->record.samples;
  ASSERT_GT(samples.size(), 150u);
  EXPECT_NEAR(samples[100].time_s - samples[99].time_s, 0.1, 1e-9);
}

TEST(TrialTest, TheSameSetupGivesTheSameOutcome) {
  Course course;
  course.scene.AddTree(0.0, 1.5);
  course.condition.adversaries.count = 1;
  const auto first = course.Run(MakeWayStack().get(), 5);
  const auto second = course.Run(MakeWayStack().get(), 5);
  ASSERT_TRUE(first.ok() && second.ok()) << first.status().ToString();
  PlannedTrial trial;
  trial.id = "x";
  EXPECT_EQ(EncodeTrialResult(ResultOf(trial, "w", course.task, *first)),
            EncodeTrialResult(ResultOf(trial, "w", course.task, *second)));
}

TEST(TrialTest, AWallThatIsRunIntoIsOneCollision) {
  Course course;
  course.scene.AddBuilding(0.0, 0.0, 2.0, 2.0);
  course.condition.time_limit_factor = 1.0;
  FakeStack stack([](const StackInput&) { return Ahead(0.8); });
  const auto outcome = course.Run(&stack);
  ASSERT_TRUE(outcome.ok()) << outcome.status().ToString();
  EXPECT_EQ(outcome->ended_by, "time limit");
  EXPECT_TRUE(outcome->metrics.timed_out);
  EXPECT_FALSE(outcome->metrics.success);
  EXPECT_GE(outcome->metrics.collisions, 1);
  EXPECT_LE(outcome->metrics.collisions, 3);  // it goes on pressing
  EXPECT_LT(outcome->metrics.collision_free_m, 9.0);
}

TEST(TrialTest, WhoSaysTooEarlyThatItArrivedHasMissed) {
  Course course;
  FakeStack stack([](const StackInput& input) {
    StackOutput output = Ahead(0.5);
    if (input.time_s > 2.0) output.state = StackState::kArrived;
    return output;
  });
  const auto outcome = course.Run(&stack);
  ASSERT_TRUE(outcome.ok());
  EXPECT_FALSE(outcome->metrics.success);
  EXPECT_EQ(ResultOf({}, "w", course.task, *outcome).Outcome(), "missed");
}

TEST(TrialTest, AStackThatCannotBeginOrGivesUpIsAFailureWithItsReason) {
  Course course;
  FakeStack unwilling([](const StackInput&) { return Ahead(0.0); });
  unwilling.begins = NotFound("no way there");
  const auto never = course.Run(&unwilling);
  ASSERT_TRUE(never.ok());
  EXPECT_EQ(never->ended_by, "stack failed");
  EXPECT_NE(never->why.find("no way there"), std::string::npos);
  FakeStack tired([](const StackInput& input) {
    StackOutput output = Ahead(0.3);
    if (input.time_s > 1.0) output = {StackState::kFailed, 0.0, 0.0, "tired"};
    return output;
  });
  const auto tried = course.Run(&tired);
  ASSERT_TRUE(tried.ok());
  EXPECT_EQ(tried->why, "tired");
  EXPECT_FALSE(tried->metrics.timed_out);
}

TEST(TrialTest, AWallIsStraightHoweverTheRobotTurnsWhileItIsSwept) {
  Course course;
  Prop& crate = course.scene.AddProp("crate", PropKind::kCrate, 0.0, 0.0);
  crate.size_m = {1.0, 20.0, 2.0};  // across its way: its west face is at x = -0.5
  crate.mass_kg = 5000.0;
  // Least squares of what is before the robot: how far the face seems turned, leftwards where the
  // robot turns to the left and rightwards where it turns to the right.
  double turned = 0.0, weight = 0.0;
  FakeStack stack([&](const StackInput& input) {
    for (const StackScan& scan : input.scans) {
      EXPECT_TRUE(scan.planar);
      EXPECT_NEAR(scan.time_s, input.time_s, 0.06);
      for (const Eigen::Vector3f& hit : scan.hits_m) {
        const Eigen::Vector3d at = scan.map_from_sensor * hit.cast<double>();
        if (std::abs(at.x() + 0.5) > 0.4 || std::abs(at.y()) > 9.0) continue;
        turned += (at.x() + 0.5) * at.y() * (input.yaw_rate_radps > 0.0 ? 1.0 : -1.0);
        weight += at.y() * at.y();
      }
    }
    StackOutput output = Ahead(0.2);
    output.yaw_rate_radps = std::fmod(input.time_s, 2.0) < 1.0 ? 1.5 : -1.5;
    if (input.time_s > 6.0) output.state = StackState::kFailed;
    return output;
  });
  ASSERT_TRUE(course.Run(&stack).ok());
  ASSERT_GT(weight, 1000.0);
  // A sweep takes 19 ms, in which the robot turns by 0.03 rad.
  EXPECT_NEAR(turned / weight, 0.0, 0.002);
}

TEST(TrialTest, AdversariesComeAndAreCounted) {
  Course course;
  course.condition.adversaries = {2, "goblin", "pursuer", 6.0};
  course.condition.time_limit_factor = 2.0;
  FakeStack stack([](const StackInput&) { return Ahead(0.3); });
  const auto outcome = course.Run(&stack, 3);
  ASSERT_TRUE(outcome.ok()) << outcome.status().ToString();
  EXPECT_GT(outcome->interventions.pursuits, 0);
  EXPECT_GT(outcome->interventions.attacks, 0);
  EXPECT_EQ(outcome->metrics.adversary_hits, outcome->interventions.hits);
  EXPECT_LT(outcome->metrics.least_time_to_collision_s, 5.0);
}

TEST(TrialTest, ARobotWithoutAPlaceIsNoTrial) {
  Course course;
  course.scene.AddBuilding(-10.0, 0.0, 5.0, 5.0);
  const auto outcome = course.Run(MakeWayStack().get());
  ASSERT_FALSE(outcome.ok());
  EXPECT_EQ(outcome.status().code(), StatusCode::kFailedPrecondition);
}

}  // namespace
}  // namespace latticeworld
