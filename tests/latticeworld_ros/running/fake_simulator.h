#ifndef LATTICEWORLD_TESTS_ROS_RUNNING_FAKE_SIMULATOR_H_
#define LATTICEWORLD_TESTS_ROS_RUNNING_FAKE_SIMULATOR_H_

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld_ros/running/simulation_run.h"

namespace latticeworld {

// Counts its steps, and remembers its seed and commands. An exception of `before` leaves it torn
// until it is reset, and it notes who looks at it or changes it meanwhile.
class FakeSimulator : public Simulator {
 public:
  explicit FakeSimulator(std::uint64_t seed, double step_s = 0.01) : seed_(seed) {
    options_.step_s = step_s;
  }

  latticeworld::Status Command(const std::string&, const VelocityCommand& command) override {
    Begin("Command");
    if (on_command) on_command(command);
    return latticeworld::Status();
  }
  latticeworld::Status CommandJoints(const std::string&,
                                     const std::vector<JointCommand>& commands) override {
    Begin("CommandJoints");
    if (on_joints) on_joints(commands);
    return latticeworld::Status();
  }
  latticeworld::Status Strike(const std::string&) override {
    Begin("Strike");
    ++strikes;
    return latticeworld::Status();
  }
  latticeworld::Status SetPolicy(const PolicyChange&) override { return NotFound("nobody"); }
  void Step() override {
    Begin("Step");
    ++step_;
    ++episode_step_;
  }
  std::shared_ptr<const WorldState> State() const override {
    Touch();
    auto state = std::make_shared<WorldState>();
    state->step = step_;
    state->episode_step = episode_step_;
    state->atmosphere = weather_;
    return state;
  }
  std::vector<Event> TakeEvents() override {
    Touch();
    return std::exchange(events, {});
  }
  Result<std::string> Spawn(const SpawnRequest& request) override {
    Begin("Spawn");
    if (request.name.empty()) return InvalidArgument("no name");
    return request.name;
  }
  latticeworld::Status Remove(const std::string&) override { return NotFound("nobody"); }
  Result<std::string> SpawnProp(const Prop& prop) override { return prop.name; }
  latticeworld::Status RemoveProp(const std::string&) override { return NotFound("nothing"); }
  latticeworld::Status OpenGate(const std::string&, double) override { return NotFound("no gate"); }
  latticeworld::Status SetWeather(const WeatherChange& change) override {
    Begin("SetWeather");
    if (change.intensity.has_value()) return InvalidArgument("intensity");
    weather_.snow_depth_m = change.snow_depth_m.value_or(0.0);
    return latticeworld::Status();
  }
  const Atmosphere& WeatherTarget() const override { return weather_; }
  void Reset(std::uint64_t seed) override {
    torn_ = false;
    Begin("Reset");
    seed_ = seed;
    episode_step_ = 0;
  }
  std::shared_ptr<const SimulatorSnapshot> Save() const override {
    Touch();
    return std::make_shared<Saved>(episode_step_);
  }
  latticeworld::Status Restore(const SimulatorSnapshot& snapshot) override {
    Begin("Restore");
    episode_step_ = dynamic_cast<const Saved&>(snapshot).episode_step;
    return latticeworld::Status();
  }
  std::string StateHash() const override {
    Touch();
    return std::to_string(episode_step_);
  }
  const Scene& scene() const override { return scene_; }
  const SimulatorOptions& options() const override { return options_; }
  std::uint64_t seed() const override { return seed_; }
  std::uint64_t episode_step() const { return episode_step_; }

  // Hears the name of a call before it does anything, on the thread that calls.
  std::function<void(const std::string& call)> before;
  std::function<void(const VelocityCommand&)> on_command;
  std::function<void(const std::vector<JointCommand>&)> on_joints;
  std::vector<Event> events;  // that TakeEvents gives away; of the thread that steps
  std::atomic<int> strikes{0};
  mutable std::atomic<bool> touched_while_torn{false};

 private:
  struct Saved : SimulatorSnapshot {
    explicit Saved(std::uint64_t step) : episode_step(step) {}
    std::uint64_t episode_step;
  };

  void Touch() const {
    if (torn_) touched_while_torn = true;
  }
  void Begin(const char* call) {
    Touch();
    if (!before) return;
    torn_ = true;
    before(call);
    torn_ = false;
  }

  Atmosphere weather_;
  Scene scene_;
  SimulatorOptions options_;
  std::uint64_t seed_, step_ = 0, episode_step_ = 0;
  bool torn_ = false;
};

// fake: gets the simulator, which lives as long as the world runs.
inline LaunchedWorld FakeWorld(const std::string& id, std::uint64_t seed,
                               FakeSimulator** fake = nullptr) {
  auto world = std::make_shared<World>();
  world->id = id;
  auto simulator = std::make_unique<FakeSimulator>(seed);
  if (fake != nullptr) *fake = simulator.get();
  return {world, std::move(simulator)};
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_ROS_RUNNING_FAKE_SIMULATOR_H_
