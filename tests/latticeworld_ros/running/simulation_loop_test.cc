#include "latticeworld_ros/running/simulation_loop.h"

#include <gtest/gtest.h>
#include <ros/time.h>

#include <cmath>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "latticeworld_ros/running/fake_simulator.h"
#include "latticeworld_ros/running/loop_recorder.h"

namespace latticeworld {
namespace {

constexpr double kStep_s = 0.01;

class SimulationLoopTest : public testing::Test {
 protected:
  SimulationLoopTest() : loop_({kStep_s, 1.0, /*start_paused=*/true}, &recorder_) { loop_.Start(); }
  // Answers the simulator, which lives until the next world.
  FakeSimulator* Begin(const std::string& id = "one") {
    FakeSimulator* fake = nullptr;
    LaunchedWorld world = FakeWorld(id, 3, &fake);
    EXPECT_TRUE(loop_.Swap(&world).ok());
    return fake;
  }

  LoopRecorder recorder_;
  SimulationLoop loop_;
};

TEST_F(SimulationLoopTest, WithoutAWorldEverythingSaysWhatToDo) {
  for (const Status& status :
       {loop_.Inspect(true).status(), loop_.Reset(1).status(), loop_.Step(1, false).status(),
        loop_.Apply([](Simulator*) { return std::string(); }).status(),
        loop_.SaveSnapshot("a").status(), loop_.RestoreSnapshot("a").status(),
        loop_.SetWeather({}).status()}) {
    EXPECT_EQ(status.code(), StatusCode::kFailedPrecondition);
    EXPECT_NE(status.message().find("generate_world"), std::string::npos);
  }
}

TEST_F(SimulationLoopTest, StepMakesExactlyNSteps) {
  Begin();
  std::uint64_t done = 0;
  ros::Time before;
  for (const std::uint32_t n : {1u, 2u, 1000u}) {
    const auto snapshot = loop_.Step(n, true);
    ASSERT_TRUE(snapshot.ok()) << snapshot.status().ToString();
    done += n;
    EXPECT_EQ(snapshot->step, done);
    EXPECT_EQ(snapshot->state_hash, std::to_string(done));
    if (n > 1) {
      EXPECT_EQ((snapshot->now - before).toNSec(), std::int64_t{n} * 10000000);
    }
    before = snapshot->now;
  }
  EXPECT_TRUE(loop_.Inspect(false)->state_hash.empty());
}

TEST_F(SimulationLoopTest, StepHasLimitsAndNeedsAPause) {
  Begin();
  EXPECT_EQ(loop_.Step(0, false).status().code(), StatusCode::kOutOfRange);
  EXPECT_EQ(loop_.Step(kMaxStepsPerCall + 1, false).status().code(), StatusCode::kOutOfRange);
  ASSERT_TRUE(loop_.SetPaused(false).ok());
  EXPECT_EQ(loop_.Step(1, false).status().code(), StatusCode::kFailedPrecondition);
}

TEST_F(SimulationLoopTest, TimeNeverFallsOverWorldsAndResets) {
  ASSERT_TRUE(loop_.SetPaused(false).ok());
  recorder_.WaitFor(5);
  Begin("one");
  recorder_.WaitFor(recorder_.times().size() + 5);
  ASSERT_TRUE(loop_.Reset(0).ok());
  Begin("two");
  ASSERT_TRUE(loop_.SetPaused(true).ok());
  ASSERT_TRUE(loop_.Step(10, false).ok());
  loop_.Stop();
  const std::vector<ros::Time> times = recorder_.times();
  for (std::size_t i = 1; i < times.size(); ++i) EXPECT_LE(times[i - 1], times[i]);
  EXPECT_EQ(recorder_.begins, 3);
}

TEST_F(SimulationLoopTest, ResetKeepsTheSeedUnlessAnotherIsGiven) {
  Begin();
  ASSERT_TRUE(loop_.Step(5, false).ok());
  EXPECT_EQ(loop_.Reset(0)->seed, 3u);
  const auto snapshot = loop_.Reset(8);
  EXPECT_EQ(snapshot->seed, 8u);
  EXPECT_EQ(snapshot->episode_step, 0u);
  EXPECT_EQ(snapshot->step, 5u);
}

TEST_F(SimulationLoopTest, WeatherChangesBetweenTwoStepsAndIsShownAtOnce) {
  Begin();
  const std::size_t shown = recorder_.times().size();
  WeatherChange snow;
  snow.snow_depth_m = 0.25;
  const auto answer = loop_.SetWeather(snow);
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  EXPECT_EQ(answer->world_id, "one");
  EXPECT_EQ(answer->target.snow_depth_m, 0.25);
  EXPECT_GT(recorder_.times().size(), shown);
  EXPECT_EQ(loop_.Inspect(false)->atmosphere.snow_depth_m, 0.25);
  WeatherChange refused;
  refused.intensity = 2.0;
  EXPECT_EQ(loop_.SetWeather(refused).status().code(), StatusCode::kInvalidArgument);
}

TEST_F(SimulationLoopTest, AChangeIsShownAtOnceAndItsErrorsAreTheCallers) {
  Begin();
  const std::size_t shown = recorder_.times().size();
  SpawnRequest request;
  request.name = "scout";
  const auto spawned = loop_.Apply([&](Simulator* simulator) { return simulator->Spawn(request); });
  ASSERT_TRUE(spawned.ok()) << spawned.status().ToString();
  EXPECT_EQ(spawned->name, "scout");
  EXPECT_EQ(spawned->world_id, "one");
  EXPECT_GT(recorder_.times().size(), shown);
  request.name.clear();
  EXPECT_EQ(
      loop_.Apply([&](Simulator* simulator) { return simulator->Spawn(request); }).status().code(),
      StatusCode::kInvalidArgument);
}

TEST_F(SimulationLoopTest, SnapshotsBringBackAStateAsOftenAsWanted) {
  Begin();
  ASSERT_TRUE(loop_.Step(7, false).ok());
  EXPECT_EQ(loop_.SaveSnapshot("seven")->snapshots, std::vector<std::string>{"seven"});
  const ros::Time before = loop_.Step(5, false)->now;
  for (int i = 0; i < 2; ++i) {
    const auto moment = loop_.RestoreSnapshot("seven");
    ASSERT_TRUE(moment.ok()) << moment.status().ToString();
    EXPECT_EQ(moment->episode_step, 7u);
    EXPECT_EQ(moment->state_hash, "7");
    EXPECT_GT(moment->now, before);
  }
  EXPECT_EQ(recorder_.restores, 2);
  const Status absent = loop_.RestoreSnapshot("eight").status();
  EXPECT_EQ(absent.code(), StatusCode::kNotFound);
  EXPECT_NE(absent.message().find("seven"), std::string::npos);
  // Another world has none of them.
  Begin("two");
  EXPECT_EQ(loop_.RestoreSnapshot("seven").status().code(), StatusCode::kNotFound);
}

TEST_F(SimulationLoopTest, SnapshotsAreFewAndTheirNamesAreReplaced) {
  Begin();
  for (std::size_t i = 0; i < kMaxSnapshots; ++i) {
    ASSERT_TRUE(loop_.SaveSnapshot("at_" + std::to_string(i)).ok());
  }
  const Status full = loop_.SaveSnapshot("one_more").status();
  EXPECT_EQ(full.code(), StatusCode::kResourceExhausted);
  EXPECT_NE(full.message().find("at_0"), std::string::npos);
  EXPECT_TRUE(loop_.SaveSnapshot("at_0").ok());
  for (const std::string& name : {std::string(), std::string(kMaxSnapshotName + 1, 'a')}) {
    EXPECT_EQ(loop_.SaveSnapshot(name).status().code(), StatusCode::kInvalidArgument);
  }
}

TEST_F(SimulationLoopTest, TheRealTimeFactorHasLimits) {
  EXPECT_EQ(*loop_.SetRealTimeFactor(0.0), 1.0);
  EXPECT_EQ(*loop_.SetRealTimeFactor(0.5), 0.0);
  for (const double factor : {-1.0, 0.001, 1001.0, std::nan("")}) {
    const Status refused = loop_.SetRealTimeFactor(factor).status();
    EXPECT_EQ(refused.code(), StatusCode::kOutOfRange) << factor;
    EXPECT_NE(refused.message().find("0.01 .. 1000"), std::string::npos);
  }
  EXPECT_EQ(*loop_.SetRealTimeFactor(2.0), 0.5);
}

TEST_F(SimulationLoopTest, JointsAndStrikesReachTheSimulator) {
  FakeSimulator* const fake = Begin();
  std::vector<std::string> joints;
  fake->on_joints = [&](const std::vector<JointCommand>& commands) {
    for (const JointCommand& command : commands) joints.push_back(command.joint);
  };
  loop_.CommandJoints("dog", {{"knee", 0.5, NAN, NAN}});
  loop_.Strike("dog");
  ASSERT_TRUE(loop_.Inspect(false).ok());
  EXPECT_EQ(joints, std::vector<std::string>{"knee"});
  EXPECT_EQ(fake->strikes, 1);
}

TEST_F(SimulationLoopTest, SwapGivesBackTheWorldBefore) {
  Begin("one");
  LaunchedWorld world = FakeWorld("two", 4);
  ASSERT_TRUE(loop_.Swap(&world).ok());
  EXPECT_EQ(world.world->id, "one");
  EXPECT_EQ(loop_.Inspect(false)->world->id, "two");
}

TEST_F(SimulationLoopTest, OfManyCommandsBetweenTwoStepsTheLastCounts) {
  std::mutex mutex;
  std::condition_variable changed;
  bool begun = false, go_on = false;
  std::vector<double> heard_mps;
  FakeSimulator* const fake = Begin();
  fake->on_command = [&](const VelocityCommand& command) {
    std::unique_lock<std::mutex> lock(mutex);
    heard_mps.push_back(command.linear_mps.x());
    begun = true;
    changed.notify_all();
    changed.wait(lock, [&] { return go_on; });  // the loop is busy
  };
  VelocityCommand command;
  loop_.Command("robot", command);
  {
    std::unique_lock<std::mutex> lock(mutex);
    changed.wait(lock, [&] { return begun; });
  }
  for (int i = 1; i <= 100000; ++i) {
    command.linear_mps.x() = i;
    loop_.Command("robot", command);
  }
  {
    const std::lock_guard<std::mutex> lock(mutex);
    go_on = true;
  }
  changed.notify_all();
  ASSERT_TRUE(loop_.Inspect(false).ok());
  EXPECT_EQ(heard_mps, (std::vector<double>{0.0, 100000.0}));
}

TEST_F(SimulationLoopTest, TimeGoesOnWhoeverAsksWithoutEnd) {
  FakeSimulator* const fake = Begin();
  // Each command is followed by the next, so that something is always left to do.
  fake->on_command = [this](const VelocityCommand& command) { loop_.Command("robot", command); };
  loop_.Command("robot", VelocityCommand());
  const auto stepped = loop_.Step(100, false);
  ASSERT_TRUE(stepped.ok()) << stepped.status().ToString();
  ASSERT_TRUE(loop_.SetPaused(false).ok());
  recorder_.WaitFor(recorder_.times().size() + 20);
  loop_.Stop();
}

TEST_F(SimulationLoopTest, StoppedLoopLetsEveryCallerGo) {
  Begin();
  std::vector<std::thread> callers;
  for (int i = 0; i < 4; ++i) {
    callers.emplace_back([&] {
      while (loop_.Inspect(false).ok()) {
      }
    });
  }
  loop_.Stop();
  for (std::thread& caller : callers) caller.join();
  EXPECT_EQ(loop_.Step(1, false).status().code(), StatusCode::kUnavailable);
  EXPECT_EQ(loop_.SetPaused(false).code(), StatusCode::kUnavailable);
}

}  // namespace
}  // namespace latticeworld
