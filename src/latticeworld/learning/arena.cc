#include "latticeworld/learning/arena.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "latticeworld/common/random.h"
#include "latticeworld/common/text.h"
#include "latticeworld/simulation/sensed.h"

namespace latticeworld {
namespace {

// Times this near to each other are the same, as the rig's lidars have it.
constexpr double kTolerance_s = 1e-9;
// So many steps run before the caller is asked again whether to go on.
constexpr int kStepsAtATime = 50;

// A suite of the first 2D lidar alone: its noise does not depend on what else is carried.
Result<std::shared_ptr<const SensorSuite>> ScannerOf(const SensorSuite& suite) {
  for (const SensorSpec& sensor : suite.sensors) {
    const auto* lidar = std::get_if<LidarModel>(&sensor.model);
    if (lidar == nullptr || lidar->ring_elevations_rad.size() != 1) continue;
    return std::make_shared<const SensorSuite>(SensorSuite{suite.name, {sensor}});
  }
  return InvalidArgument("the sensor suite " + Quote(suite.name) +
                         " has no 2D lidar; one that has is \"scanner\"");
}

}  // namespace

Arena::Arena(std::shared_ptr<const SensorSuite> scanner, std::unique_ptr<Simulator> simulator,
             std::unique_ptr<SensorRig> rig)
    : scanner_(std::move(scanner)), simulator_(std::move(simulator)), rig_(std::move(rig)) {}

Result<std::unique_ptr<Arena>> Arena::Create(std::shared_ptr<const Scene> scene,
                                             const ArenaOptions& options, std::uint64_t seed) {
  LW_ASSIGN_OR_RETURN(std::unique_ptr<Simulator> simulator,
                      Simulator::Create(scene, options.simulator, seed));
  std::shared_ptr<const SensorSuite> scanner;
  std::unique_ptr<SensorRig> rig;
  if (options.sensors != nullptr) {
    LW_ASSIGN_OR_RETURN(scanner, ScannerOf(*options.sensors));
    SensorRigOptions rig_options;
    rig_options.origin = options.origin;
    LW_ASSIGN_OR_RETURN(rig, SensorRig::Create(std::move(scene), rig_options,
                                               [scanner](const SensedAgent&) { return scanner; }));
  }
  return std::unique_ptr<Arena>(
      new Arena(std::move(scanner), std::move(simulator), std::move(rig)));
}

const LidarModel* Arena::scanner() const {
  return scanner_ == nullptr ? nullptr : &std::get<LidarModel>(scanner_->sensors.front().model);
}

double Arena::scan_rate_hz() const { return scanner_->sensors.front().rate_hz; }

void Arena::RestartRig() {
  senses_ = false;
  sweeps_.clear();
  events_.clear();
}

void Arena::Reset(std::uint64_t seed) {
  simulator_->Reset(seed);
  RestartRig();
}

Status Arena::Restore(const SimulatorSnapshot& snapshot) {
  LW_RETURN_IF_ERROR(simulator_->Restore(snapshot));
  RestartRig();
  return Status();
}

std::uint64_t Arena::FirstScannedStep(std::uint64_t last) const {
  const double step_s = simulator_->options().step_s;
  const double rate_hz = scan_rate_hz();
  // The last sweep that is complete by then, and the one after it, which a next call may complete.
  const double complete =
      std::floor((static_cast<double>(last) * step_s + kTolerance_s) * rate_hz) - 1.0;
  const double begin_s = std::max(0.0, complete) / rate_hz;
  // One step of caution for what rounding does to the division.
  return static_cast<std::uint64_t>(std::max(0.0, std::ceil(begin_s / step_s - 1e-6)));
}

Status Arena::Sense(std::uint64_t first_scanned) {
  const SensedWorld world = Sensed(*simulator_->State(), *simulator_->options().species);
  // One step before the rig is shown where robots come from.
  const bool matters = world.step >= first_scanned;
  if (!senses_) rig_->Restart(StreamSeed(simulator_->seed(), "sensors"));
  senses_ = true;
  const auto wanted = [&](const std::string& robot, const SensorSpec&) {
    SensorWish wish;
    wish.any = matters && std::find(scanned_.begin(), scanned_.end(), robot) != scanned_.end();
    return wish;
  };
  auto frames = rig_->Step(world, simulator_->options().step_s, wanted);
  if (!frames.ok()) return frames.status();
  for (SensorFrame& frame : *frames) {
    sweeps_[frame.robot] = std::get<LidarSweep>(std::move(frame.reading));
  }
  return Status();
}

Status Arena::Go(int steps, bool senses, const std::function<Status()>& check) {
  const std::uint64_t last = simulator_->State()->episode_step + static_cast<std::uint64_t>(steps);
  const std::uint64_t first_scanned = senses ? FirstScannedStep(last) : 0;
  std::uint64_t now = last - static_cast<std::uint64_t>(steps);
  for (int step = 0; step < steps; ++step) {
    if (check != nullptr && step > 0 && step % kStepsAtATime == 0) LW_RETURN_IF_ERROR(check());
    simulator_->Step();
    if (senses && ++now + 1 >= first_scanned) LW_RETURN_IF_ERROR(Sense(first_scanned));
  }
  return Status();
}

Status Arena::Advance(int steps, const std::vector<std::string>& scanned,
                      const std::function<Status()>& check) {
  (void)simulator_->TakeEvents();  // of resets and spawns, as between two calls of lockstep
  const bool senses = rig_ != nullptr && !scanned.empty();
  if (!senses) senses_ = false;
  scanned_ = scanned;
  for (auto sweep = sweeps_.begin(); sweep != sweeps_.end();) {
    const bool stays =
        senses_ && std::find(scanned.begin(), scanned.end(), sweep->first) != scanned.end();
    sweep = stays ? std::next(sweep) : sweeps_.erase(sweep);
  }
  const Status status = Go(steps, senses, check);
  if (!status.ok()) RestartRig();
  events_ = simulator_->TakeEvents();
  return status;
}

const LidarSweep* Arena::SweepOf(const std::string& robot) const {
  const auto found = sweeps_.find(robot);
  return found == sweeps_.end() ? nullptr : &found->second;
}

}  // namespace latticeworld
