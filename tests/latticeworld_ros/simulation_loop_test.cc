#include "latticeworld_ros/simulation_loop.h"

#include <gtest/gtest.h>
#include <ros/console.h>

#include <atomic>
#include <cmath>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace latticeworld {
namespace {

constexpr double kStep_s = 0.01;

// Counts, and remembers its seed and commands.
class FakeSimulator : public Simulator {
 public:
  explicit FakeSimulator(std::uint64_t seed) : seed_(seed) { options_.step_s = kStep_s; }
  Status Command(const std::string& agent, const VelocityCommand& command) override {
    if (on_command) on_command(command);
    return agent == "robot" ? Status() : NotFound(agent);
  }
  latticeworld::Status CommandJoints(const std::string&,
                                     const std::vector<JointCommand>& commands) override {
    if (on_joints) on_joints(commands);
    return latticeworld::Status();
  }
  latticeworld::Status Strike(const std::string&) override {
    ++strikes;
    return latticeworld::Status();
  }
  latticeworld::Status SetPolicy(const PolicyChange&) override { return NotFound("nobody"); }
  void Step() override {
    if (episode_step_ == fails_at) throw std::runtime_error("numbers ran away");
    ++step_;
    ++episode_step_;
  }
  std::shared_ptr<const WorldState> State() const override {
    auto state = std::make_shared<WorldState>();
    state->step = step_;
    state->episode_step = episode_step_;
    state->atmosphere = weather_;
    return state;
  }
  std::vector<Event> TakeEvents() override { return {}; }
  Result<std::string> Spawn(const SpawnRequest& request) override {
    if (request.name == "too much") throw std::bad_alloc();
    if (request.name.empty()) return InvalidArgument("no name");
    return request.name;
  }
  latticeworld::Status Remove(const std::string&) override { return NotFound("nobody"); }
  Result<std::string> SpawnElement(const Element& element) override { return element.name; }
  latticeworld::Status RemoveElement(const std::string&) override { return NotFound("nothing"); }
  latticeworld::Status OpenGate(const std::string&, double) override { return NotFound("no gate"); }
  latticeworld::Status SetWeather(const WeatherChange& change) override {
    if (change.intensity.has_value()) return InvalidArgument("intensity");
    weather_.snow_depth_m = change.snow_depth_m.value_or(0.0);
    return latticeworld::Status();
  }
  const Atmosphere& WeatherTarget() const override { return weather_; }
  void Reset(std::uint64_t seed) override {
    seed_ = seed;
    episode_step_ = 0;
  }
  std::shared_ptr<const SimulatorSnapshot> Save() const override {
    return std::make_shared<Saved>(episode_step_);
  }
  latticeworld::Status Restore(const SimulatorSnapshot& snapshot) override {
    episode_step_ = dynamic_cast<const Saved&>(snapshot).episode_step;
    return latticeworld::Status();
  }
  std::string StateHash() const override { return std::to_string(episode_step_); }
  const Scene& scene() const override { return scene_; }
  const SimulatorOptions& options() const override { return options_; }
  std::uint64_t seed() const override { return seed_; }

  std::function<void(const VelocityCommand&)> on_command;
  std::function<void(const std::vector<JointCommand>&)> on_joints;
  std::atomic<int> strikes{0};
  std::uint64_t fails_at = ~std::uint64_t{0};  // episode step

 private:
  struct Saved : SimulatorSnapshot {
    explicit Saved(std::uint64_t step) : episode_step(step) {}
    std::uint64_t episode_step;
  };

  Atmosphere weather_;
  Scene scene_;
  SimulatorOptions options_;
  std::uint64_t seed_, step_ = 0, episode_step_ = 0;
};

// Remembers every time that it is told, and lets a test wait for a count of them.
class Recorder : public SimulationListener {
 public:
  void OnTick(const Tick& tick) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    times_.push_back(tick.now);
    changed_.notify_all();
  }
  void OnStandstill(ros::Time now) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    times_.push_back(now);
    changed_.notify_all();
  }
  void OnBegin() override { ++begins; }
  void OnRestore() override { ++restores; }
  void OnStatistics(const LoopStatistics& statistics) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    failure_ = statistics.failure;
    changed_.notify_all();
  }

  void WaitForFailure(const std::string& words) {
    std::unique_lock<std::mutex> lock(mutex_);
    ASSERT_TRUE(changed_.wait_for(lock, std::chrono::seconds(60),
                                  [&] { return failure_.find(words) != std::string::npos; }));
  }

  void WaitFor(std::size_t count) {
    std::unique_lock<std::mutex> lock(mutex_);
    ASSERT_TRUE(
        changed_.wait_for(lock, std::chrono::seconds(60), [&] { return times_.size() >= count; }));
  }
  std::vector<ros::Time> times() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return times_;
  }
  std::atomic<int> begins{0};
  std::atomic<int> restores{0};

 private:
  std::string failure_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<ros::Time> times_;
};

RunningWorld NewWorld(const std::string& id, std::uint64_t seed) {
  auto world = std::make_shared<World>();
  world->id = id;
  return {world, std::make_unique<FakeSimulator>(seed)};
}

class SimulationLoopTest : public testing::Test {
 protected:
  SimulationLoopTest() : loop_({kStep_s, 1.0, /*start_paused=*/true}, &recorder_) { loop_.Start(); }
  void Begin(const std::string& id = "one") {
    RunningWorld world = NewWorld(id, 3);
    ASSERT_TRUE(loop_.Swap(&world).ok());
  }

  Recorder recorder_;
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
  auto simulator = std::make_unique<FakeSimulator>(3);
  FakeSimulator* const fake = simulator.get();
  std::vector<std::string> joints;
  simulator->on_joints = [&](const std::vector<JointCommand>& commands) {
    for (const JointCommand& command : commands) joints.push_back(command.joint);
  };
  RunningWorld world{std::make_shared<World>(), std::move(simulator)};
  ASSERT_TRUE(loop_.Swap(&world).ok());
  loop_.CommandJoints("dog", {{"knee", 0.5, NAN, NAN}});
  loop_.Strike("dog");
  ASSERT_TRUE(loop_.Inspect(false).ok());
  EXPECT_EQ(joints, std::vector<std::string>{"knee"});
  EXPECT_EQ(fake->strikes, 1);
}

TEST_F(SimulationLoopTest, ASimulatorThatFailsStandsStillUntilAReset) {
  auto simulator = std::make_unique<FakeSimulator>(3);
  simulator->fails_at = 4;
  RunningWorld world{std::make_shared<World>(), std::move(simulator)};
  ASSERT_TRUE(loop_.Swap(&world).ok());
  const Status failed = loop_.Step(10, false).status();
  EXPECT_EQ(failed.code(), StatusCode::kInternal);
  EXPECT_NE(failed.message().find("numbers ran away"), std::string::npos);
  EXPECT_EQ(loop_.Step(1, false).status().code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(loop_.SaveSnapshot("a").status().code(), StatusCode::kFailedPrecondition);
  ASSERT_TRUE(loop_.SetPaused(false).ok());
  recorder_.WaitForFailure("numbers ran away");
  EXPECT_EQ(loop_.Inspect(false)->episode_step, 4u);  // running, and standing still
  ASSERT_TRUE(loop_.SetPaused(true).ok());
  ASSERT_TRUE(loop_.Reset(0).ok());
  EXPECT_TRUE(loop_.Step(3, false).ok());
}

TEST_F(SimulationLoopTest, SwapGivesBackTheWorldBefore) {
  Begin("one");
  RunningWorld world = NewWorld("two", 4);
  ASSERT_TRUE(loop_.Swap(&world).ok());
  EXPECT_EQ(world.world->id, "one");
  EXPECT_EQ(loop_.Inspect(false)->world->id, "two");
}

TEST_F(SimulationLoopTest, AStepCallEndsWhenItsWorldDoes) {
  Begin();
  Status status;
  std::thread caller([&] { status = loop_.Step(kMaxStepsPerCall, false).status(); });
  // Once a step has been made, the call is under way.
  const std::size_t before = recorder_.times().size();
  recorder_.WaitFor(before + 100);
  RunningWorld world = NewWorld("two", 4);
  ASSERT_TRUE(loop_.Swap(&world).ok());
  caller.join();
  // On a fast machine all its steps may be done by then.
  EXPECT_TRUE(status.ok() || status.code() == StatusCode::kAborted) << status.ToString();
}

TEST_F(SimulationLoopTest, APauseEndsAStepCallAndShowsWhereItEnded) {
  Begin();
  Status status;
  std::thread caller([&] { status = loop_.Step(kMaxStepsPerCall, false).status(); });
  recorder_.WaitFor(recorder_.times().size() + 100);
  ASSERT_TRUE(loop_.SetPaused(true).ok());
  caller.join();
  EXPECT_TRUE(status.ok() || status.code() == StatusCode::kAborted) << status.ToString();
  EXPECT_TRUE(loop_.Inspect(false)->paused);
}

TEST_F(SimulationLoopTest, OfManyCommandsBetweenTwoStepsTheLastCounts) {
  std::mutex mutex;
  std::condition_variable changed;
  bool begun = false, go_on = false;
  std::vector<double> heard_mps;
  auto simulator = std::make_unique<FakeSimulator>(3);
  simulator->on_command = [&](const VelocityCommand& command) {
    std::unique_lock<std::mutex> lock(mutex);
    heard_mps.push_back(command.linear_mps.x());
    begun = true;
    changed.notify_all();
    changed.wait(lock, [&] { return go_on; });  // the loop is busy
  };
  RunningWorld world{std::make_shared<World>(), std::move(simulator)};
  ASSERT_TRUE(loop_.Swap(&world).ok());
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
  auto simulator = std::make_unique<FakeSimulator>(3);
  // Each command is followed by the next, so that something is always left to do.
  simulator->on_command = [this](const VelocityCommand& command) {
    loop_.Command("robot", command);
  };
  RunningWorld world{std::make_shared<World>(), std::move(simulator)};
  ASSERT_TRUE(loop_.Swap(&world).ok());
  loop_.Command("robot", VelocityCommand());
  const auto stepped = loop_.Step(100, false);
  ASSERT_TRUE(stepped.ok()) << stepped.status().ToString();
  ASSERT_TRUE(loop_.SetPaused(false).ok());
  recorder_.WaitFor(recorder_.times().size() + 20);
  loop_.Stop();
}

TEST_F(SimulationLoopTest, AnExceptionIsTheCallersAndTheLoopGoesOn) {
  Begin();
  SpawnRequest request;
  request.name = "too much";
  const auto spawn = [&](Simulator* simulator) { return simulator->Spawn(request); };
  EXPECT_EQ(loop_.Apply(spawn).status().code(), StatusCode::kInternal);
  EXPECT_TRUE(loop_.Step(2, false).ok());
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
