#include "latticeworld/sensing/sensor_rig.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "latticeworld/common/parallel.h"
#include "latticeworld/common/work_crew.h"
#include "latticeworld/sensing/rig_sensor.h"
#include "latticeworld/sensing/rig_world.h"

namespace latticeworld {
namespace {

using SuiteOf = std::function<std::shared_ptr<const SensorSuite>(const SensedAgent&)>;

bool TracesRays(const SensorSpec& spec) {
  return std::holds_alternative<LidarModel>(spec.model) ||
         std::holds_alternative<CameraSensor>(spec.model);
}

struct MountedSensor {
  std::shared_ptr<const SensorSpec> spec;
  SensorClock clock;
  std::unique_ptr<RigSensor> sensor;
};

struct Robot {
  std::vector<MountedSensor> sensors;  // by name
  bool traces_rays = false;
  std::optional<SensedAgent> before;  // as the last step had it
};

// A robot's part of a step: what is wanted of its sensors, and what they gave.
struct RobotStep {
  const std::string* name = nullptr;
  Robot* robot = nullptr;
  RigStep step;
  std::vector<SensorWish> wishes;  // by sensor
  std::vector<SensorFrame> frames;
  Status status;
  std::exception_ptr thrown;

  bool is_wanted() const {
    return std::any_of(wishes.begin(), wishes.end(),
                       [](const SensorWish& wish) { return wish.any; });
  }
  // Throws nothing, for it runs on any thread.
  void Run() noexcept {
    try {
      std::vector<MountedSensor>& sensors = robot->sensors;
      for (std::size_t i = 0; i < sensors.size() && status.ok(); ++i) {
        status = sensors[i].sensor->Step(step, wishes[i], &frames);
      }
      if (!sensors.empty()) robot->before = *step.agent;
    } catch (...) {  // memory that ended
      thrown = std::current_exception();
    }
  }
};

class SensorRigImpl final : public SensorRig {
 public:
  SensorRigImpl(std::shared_ptr<const Scene> scene, const SensorRigOptions& options,
                SuiteOf suite_of)
      : options_(options), shared_(std::move(scene), options), suite_of_(std::move(suite_of)) {}

  Result<std::vector<SensorFrame>> Step(const SensedWorld& world, double step_s,
                                        const Wanted& wanted) override {
    if (last_step_ && world.step != *last_step_ + 1) ForgetRobots(world);
    last_step_ = world.step;
    const std::map<std::string, std::uint32_t> indices = Meet(world);
    shared_.BeginStep(world, EyesIn(world, indices));

    std::vector<RobotStep> steps = StepsIn(world, step_s, indices, wanted);
    RunAll(&steps);

    std::vector<SensorFrame> frames;
    for (RobotStep& one : steps) {
      if (one.thrown != nullptr || !one.status.ok()) {
        Restart(options_.seed);  // some have had the step, some have not
        if (one.thrown != nullptr) std::rethrow_exception(one.thrown);
        return one.status.WithContext("sensors of " + *one.name);
      }
      std::move(one.frames.begin(), one.frames.end(), std::back_inserter(frames));
    }
    return frames;
  }

  void Restart(std::uint64_t seed) override {
    options_.seed = seed;
    robots_.clear();
    last_step_.reset();
  }

  bool NeedsStep(std::uint64_t step, double step_s, const Wanted& wanted) const override {
    if (!last_step_) return true;
    for (const auto& [name, robot] : robots_) {
      for (const MountedSensor& mounted : robot.sensors) {
        const bool matters =
            mounted.sensor->IsCollecting() || mounted.clock.IsDue(step + 1, step_s);
        if (matters && wanted(name, *mounted.spec).any) return true;
      }
    }
    return false;
  }

 private:
  std::vector<RobotStep> StepsIn(const SensedWorld& world, double step_s,
                                 const std::map<std::string, std::uint32_t>& indices,
                                 const Wanted& wanted) {
    std::vector<RobotStep> steps;
    steps.reserve(robots_.size());
    for (auto& [name, robot] : robots_) {
      RobotStep& one = steps.emplace_back();
      one.name = &name;
      one.robot = &robot;
      one.step.shared = &shared_;
      one.step.agent_index = indices.at(name);
      one.step.agent = &world.agents[one.step.agent_index];
      one.step.before = robot.before ? &*robot.before : nullptr;
      one.step.step_s = step_s;
      for (const MountedSensor& mounted : robot.sensors)
        one.wishes.push_back(wanted(name, *mounted.spec));
    }
    return steps;
  }
  // Runs the steps of the robots, of several at once where several have something to do.
  void RunAll(std::vector<RobotStep>* steps) {
    const int threads = options_.threads > 0 ? options_.threads : CoreCount();
    const auto busy = std::count_if(steps->begin(), steps->end(), [](const RobotStep& one) {
      return one.robot->traces_rays && one.is_wanted();
    });
    // The threads that are left over go to the rays of each sensor.
    const int of_sensor = std::max(1, threads / std::max(1, static_cast<int>(busy)));
    for (RobotStep& one : *steps) one.step.threads = of_sensor;
    if (busy < 2 || threads < 2) {
      for (RobotStep& one : *steps) one.Run();
      return;
    }
    if (!crew_) crew_ = std::make_unique<WorkCrew>(threads);
    crew_->Run(static_cast<int>(steps->size()), [&](int part) { (*steps)[part].Run(); });
  }
  // After a gap robots are as new; their sensors are kept where that is the same.
  void ForgetRobots(const SensedWorld& world) {
    std::map<std::string, Robot> kept;
    for (const SensedAgent& agent : world.agents) {
      const auto robot = robots_.find(agent.name);
      if (robot == robots_.end() || !robot->second.before) continue;
      if (robot->second.before->height_m != agent.height_m) continue;
      std::vector<MountedSensor>& sensors = robot->second.sensors;
      const bool forgets =
          std::all_of(sensors.begin(), sensors.end(),
                      [](const MountedSensor& mounted) { return mounted.sensor->Forget(); });
      if (!forgets) continue;
      robot->second.before.reset();
      kept.insert(robots_.extract(robot));
    }
    robots_ = std::move(kept);
  }
  // Robots that came get their sensors, those that went lose them. Indices into the world's agents.
  std::map<std::string, std::uint32_t> Meet(const SensedWorld& world) {
    std::map<std::string, std::uint32_t> indices;
    for (std::size_t i = 0; i < world.agents.size(); ++i) {
      const SensedAgent& agent = world.agents[i];
      if (!agent.has_sensors) continue;
      indices[agent.name] = static_cast<std::uint32_t>(i);
      if (robots_.count(agent.name) == 0) robots_.emplace(agent.name, Equip(agent));
    }
    for (auto robot = robots_.begin(); robot != robots_.end();) {
      robot = indices.count(robot->first) == 0 ? robots_.erase(robot) : std::next(robot);
    }
    return indices;
  }

  Robot Equip(const SensedAgent& agent) const {
    Robot robot;
    const std::shared_ptr<const SensorSuite> suite = suite_of_(agent);
    if (suite == nullptr) return robot;
    for (const SensorSpec& sensor : suite->sensors) {
      // Shares the suite's life.
      std::shared_ptr<const SensorSpec> spec(suite, &sensor);
      robot.traces_rays = robot.traces_rays || TracesRays(sensor);
      robot.sensors.push_back(
          {spec, SensorClock(sensor.rate_hz), MakeRigSensor(spec, agent, options_.seed, options_)});
    }
    std::stable_sort(
        robot.sensors.begin(), robot.sensors.end(),
        [](const MountedSensor& a, const MountedSensor& b) { return a.spec->name < b.spec->name; });
    return robot;
  }

  std::vector<Eigen::Vector3d> EyesIn(const SensedWorld& world,
                                      const std::map<std::string, std::uint32_t>& indices) const {
    std::vector<Eigen::Vector3d> eyes_m;
    for (const auto& [name, robot] : robots_) {
      if (!robot.traces_rays) continue;
      eyes_m.push_back(world.agents[indices.at(name)].map_from_base.translation());
    }
    return eyes_m;
  }

  SensorRigOptions options_;
  RigWorld shared_;
  SuiteOf suite_of_;
  std::map<std::string, Robot> robots_;  // those in the world
  std::optional<std::uint64_t> last_step_;
  std::unique_ptr<WorkCrew> crew_;  // of options_.threads; null: it was not needed yet
};

}  // namespace

Result<std::unique_ptr<SensorRig>> SensorRig::Create(std::shared_ptr<const Scene> scene,
                                                     const SensorRigOptions& options,
                                                     SuiteOf suite_of) {
  if (scene == nullptr) return InvalidArgument("a sensor rig needs a scene");
  return std::unique_ptr<SensorRig>(
      std::make_unique<SensorRigImpl>(std::move(scene), options, std::move(suite_of)));
}

}  // namespace latticeworld
