#include "latticeworld_ros/simulation_loop.h"

#include <ros/console.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <future>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld_ros/stopwatch.h"

namespace latticeworld {
namespace {

constexpr std::chrono::milliseconds kStandstillPeriod(100);
constexpr std::chrono::seconds kStatisticsPeriod(1);
// Further behind than this the loop gives up the lost time instead of running after it.
constexpr std::chrono::milliseconds kMaxLag(100);

Status NoWorld() {
  return FailedPrecondition("no world is running; call generate_world or load_world first");
}

std::vector<std::string> NamesOf(
    const std::map<std::string, std::shared_ptr<const SimulatorSnapshot>>& snapshots) {
  std::vector<std::string> names;
  for (const auto& entry : snapshots) names.push_back(entry.first);
  return names;
}

}  // namespace

Status CheckRealTimeFactor(double factor) {
  if (factor == 0.0 || (factor >= 0.01 && factor <= 1000.0)) return Status();
  return Status(StatusCode::kOutOfRange, "factor is " + FormatDouble(factor) +
                                             "; legal is 0 (as fast as possible) or 0.01 .. 1000");
}

SimulationLoop::SimulationLoop(const SimulationLoopOptions& options, SimulationListener* listener)
    : options_(options),
      listener_(listener),
      step_ns_(static_cast<std::uint64_t>(std::llround(options.step_s * 1e9))),
      tasks_(Unavailable("world_server is shutting down")),
      paused_(options.start_paused),
      real_time_factor_(options.real_time_factor) {}

SimulationLoop::~SimulationLoop() { Stop(); }

void SimulationLoop::Start() {
  thread_ = std::thread([this] { Run(); });
}

void SimulationLoop::Stop() {
  tasks_.Stop();
  if (thread_.joinable()) thread_.join();
}

Result<ros::Time> SimulationLoop::Swap(RunningWorld* world) {
  return tasks_.Call<ros::Time>([this, world]() -> Result<ros::Time> {
    FinishJob(Status(StatusCode::kAborted, "another world has taken the place of this one"));
    std::swap(running_, *world);
    snapshots_.clear();
    failure_.clear();
    listener_->OnBegin();
    Settle();
    return Now();
  });
}

Result<SimulationLoop::Change> SimulationLoop::Apply(
    const std::function<Result<std::string>(Simulator*)>& change) {
  return tasks_.Call<Change>([this, change]() -> Result<Change> {
    if (running_.simulator == nullptr) return NoWorld();
    LW_ASSIGN_OR_RETURN(const std::string name, change(running_.simulator.get()));
    Settle();
    return Change{name, running_.world->id};
  });
}

Result<SimulationLoop::WeatherAnswer> SimulationLoop::SetWeather(const WeatherChange& change) {
  return tasks_.Call<WeatherAnswer>([this, change]() -> Result<WeatherAnswer> {
    if (running_.simulator == nullptr) return NoWorld();
    LW_RETURN_IF_ERROR(running_.simulator->SetWeather(change));
    Settle();
    return WeatherAnswer{running_.world->id, Now(), running_.simulator->WeatherTarget()};
  });
}

void SimulationLoop::Command(const std::string& agent, const VelocityCommand& command) {
  if (commands_.Velocity(agent, command)) PostCommands();
}

void SimulationLoop::CommandJoints(const std::string& agent, std::vector<JointCommand> commands) {
  if (commands_.Joints(agent, std::move(commands))) PostCommands();
}

void SimulationLoop::Strike(const std::string& agent) {
  if (commands_.Strike(agent)) PostCommands();
}

void SimulationLoop::PostCommands() {
  // Nobody waits: once the loop has stopped there is no robot to drive.
  (void)tasks_.Post([this] { commands_.Apply(running_.simulator.get()); });
}

Result<SimulationLoop::Moment> SimulationLoop::Inspect(bool hash) {
  return tasks_.Call<Moment>([this, hash]() -> Result<Moment> {
    if (running_.simulator == nullptr) return NoWorld();
    return Look(hash);
  });
}

Result<SimulationLoop::Moment> SimulationLoop::Reset(std::uint64_t seed) {
  return tasks_.Call<Moment>([this, seed]() -> Result<Moment> {
    if (running_.simulator == nullptr) return NoWorld();
    FinishJob(Status(StatusCode::kAborted, "the world was reset"));
    running_.simulator->Reset(seed != 0 ? seed : running_.simulator->seed());
    failure_.clear();
    listener_->OnBegin();
    Settle();
    return Look(true);
  });
}

Result<SimulationLoop::Moment> SimulationLoop::Step(std::uint32_t steps, bool hash) {
  if (steps < 1 || steps > kMaxStepsPerCall) {
    return Status(StatusCode::kOutOfRange, std::to_string(steps) +
                                               " steps are not legal; legal "
                                               "are 1 .. " +
                                               std::to_string(kMaxStepsPerCall));
  }
  using Promise = std::shared_ptr<std::promise<Result<Moment>>>;
  return tasks_.CallLater<Moment>([this, steps, hash](Promise promise) {
    if (running_.simulator == nullptr) {
      promise->set_value(NoWorld());
    } else if (!paused_) {
      promise->set_value(FailedPrecondition("the simulation is running; call pause first"));
    } else if (!failure_.empty()) {
      promise->set_value(FailedPrecondition(failure_));
    } else if (job_) {
      promise->set_value(ResourceExhausted("another step call is not done yet"));
    } else {
      job_ = StepJob{steps, hash,
                     [promise](Result<Moment> moment) { promise->set_value(std::move(moment)); }};
    }
  });
}

Status SimulationLoop::SetPaused(bool paused) {
  return tasks_
      .Call<bool>([this, paused]() -> Result<bool> {
        const bool cut_short = job_.has_value();
        FinishJob(Status(StatusCode::kAborted, paused ? "paused meanwhile" : "unpaused meanwhile"));
        const bool changed = paused != paused_;
        paused_ = paused;
        if (changed) next_due_ = Clock::now();
        if (paused && (changed || cut_short)) Settle();
        return true;
      })
      .status();
}

Result<double> SimulationLoop::SetRealTimeFactor(double factor) {
  LW_RETURN_IF_ERROR(CheckRealTimeFactor(factor));
  return tasks_.Call<double>([this, factor]() -> Result<double> {
    next_due_ = Clock::now();
    return std::exchange(real_time_factor_, factor);
  });
}

Result<SimulationLoop::Moment> SimulationLoop::SaveSnapshot(const std::string& name) {
  if (name.empty() || name.size() > kMaxSnapshotName) {
    return InvalidArgument("name has " + std::to_string(name.size()) +
                           " characters; legal are 1 .. " + std::to_string(kMaxSnapshotName));
  }
  return tasks_.Call<Moment>([this, name]() -> Result<Moment> {
    if (running_.simulator == nullptr) return NoWorld();
    if (!failure_.empty()) return FailedPrecondition(failure_);
    if (snapshots_.size() >= kMaxSnapshots && snapshots_.count(name) == 0) {
      return ResourceExhausted(
          "there are " + std::to_string(kMaxSnapshots) + " snapshots, as many as are kept: " +
          Join(NamesOf(snapshots_), ", ") + "; one of their names replaces it");
    }
    snapshots_[name] = running_.simulator->Save();
    return Look(true);
  });
}

Result<SimulationLoop::Moment> SimulationLoop::RestoreSnapshot(const std::string& name) {
  return tasks_.Call<Moment>([this, name]() -> Result<Moment> {
    if (running_.simulator == nullptr) return NoWorld();
    const auto snapshot = snapshots_.find(name);
    if (snapshot == snapshots_.end()) {
      return NotFound("there is no snapshot " + Quote(name) + "; " +
                      (snapshots_.empty() ? "there are none: save_snapshot makes one"
                                          : "there are " + Join(NamesOf(snapshots_), ", ")));
    }
    FinishJob(Status(StatusCode::kAborted, "a snapshot was restored"));
    LW_RETURN_IF_ERROR(running_.simulator->Restore(*snapshot->second));
    failure_.clear();
    listener_->OnRestore();
    Settle();
    return Look(true);
  });
}

void SimulationLoop::Run() {
  next_due_ = statistics_begin_ = Clock::now();
  Settle();
  for (;;) {
    if (!WaitUntil(Clock::now())) break;
    TellStatistics();
    if (job_) {
      const bool last = --job_->left == 0;
      Advance(last);
      if (!failure_.empty()) {
        FinishJob(Internal(failure_));
      } else if (last) {
        FinishJob(Status());
      }
    } else if (paused_ || !failure_.empty()) {
      listener_->OnStandstill(Now());
      if (!WaitUntil(Clock::now() + kStandstillPeriod)) break;
      next_due_ = Clock::now();
    } else {
      Advance(false);
      Pace();
    }
  }
  // Whoever waits hears that nothing will come.
  tasks_.Drop();
  job_.reset();
}

bool SimulationLoop::WaitUntil(const Clock::time_point& due) {
  // Lockstep does not wait.
  return tasks_.WaitUntil(due, [this] { return job_.has_value(); });
}

void SimulationLoop::Pace() {
  // Without a world there is nothing to hurry for.
  const double factor = real_time_factor_ > 0.0         ? real_time_factor_
                        : running_.simulator == nullptr ? 1.0
                                                        : 0.0;
  const Clock::time_point now = Clock::now();
  if (factor == 0.0) {
    next_due_ = now;
    return;
  }
  next_due_ += std::chrono::nanoseconds(std::llround(static_cast<double>(step_ns_) / factor));
  if (now - next_due_ > kMaxLag) next_due_ = now;
  if (next_due_ > now) (void)WaitUntil(next_due_);  // a stop is seen at the top of Run
}

void SimulationLoop::Advance(bool settled) {
  if (running_.simulator != nullptr) {
    const Stopwatch watch;
    try {
      running_.simulator->Step();
    } catch (const std::exception& error) {
      // Half a step is no state to go on from, but the node can.
      failure_ = "the simulation failed in the step after " +
                 std::to_string(running_.simulator->State()->step) + " (" + error.what() +
                 "); reset_world, restore_snapshot or another world let it go on";
      ROS_ERROR_STREAM(failure_);
      return;
    }
    const double seconds = watch.seconds();
    ++steps_timed_;
    steps_total_s_ += seconds;
    steps_max_s_ = std::max(steps_max_s_, seconds);
  }
  ++tick_;
  listener_->OnTick({tick_, Now(), running_.simulator.get(),
                     running_.world ? running_.world->id : std::string(), settled});
}

void SimulationLoop::Settle() {
  // A tick of its own: two states never share a stamp, for tf would drop the second.
  ++tick_;
  listener_->OnTick({tick_, Now(), running_.simulator.get(),
                     running_.world ? running_.world->id : std::string(), true});
}

void SimulationLoop::FinishJob(Status status) {
  if (!job_) return;
  const StepJob job = std::move(*job_);
  job_.reset();
  if (status.ok()) {
    job.done(Look(job.hash));
  } else {
    job.done(std::move(status));
  }
}

SimulationLoop::Moment SimulationLoop::Look(bool hash) const {
  const std::shared_ptr<const WorldState> state = running_.simulator->State();
  Moment moment;
  moment.world = running_.world;
  moment.now = Now();
  moment.seed = running_.simulator->seed();
  moment.step = state->step;
  moment.episode_step = state->episode_step;
  moment.paused = paused_;
  moment.atmosphere = state->atmosphere;
  if (hash) moment.state_hash = running_.simulator->StateHash();
  moment.snapshots = NamesOf(snapshots_);
  moment.species = running_.simulator->options().species;
  return moment;
}

void SimulationLoop::TellStatistics() {
  const Clock::time_point now = Clock::now();
  const double wall_s = std::chrono::duration<double>(now - statistics_begin_).count();
  if (now - statistics_begin_ < kStatisticsPeriod) return;
  LoopStatistics statistics;
  statistics.now = Now();
  statistics.paused = paused_;
  statistics.failure = failure_;
  statistics.wanted_factor = real_time_factor_;
  statistics.real_time_factor =
      static_cast<double>(tick_ - statistics_tick_) * options_.step_s / wall_s;
  if (steps_timed_ > 0) {
    statistics.mean_step_s = steps_total_s_ / static_cast<double>(steps_timed_);
    statistics.max_step_s = steps_max_s_;
  }
  statistics.simulator = running_.simulator.get();
  if (running_.world) statistics.world_id = running_.world->id;
  listener_->OnStatistics(statistics);

  statistics_begin_ = now;
  statistics_tick_ = tick_;
  steps_timed_ = 0;
  steps_total_s_ = steps_max_s_ = 0.0;
}

ros::Time SimulationLoop::Now() const { return ros::Time().fromNSec(tick_ * step_ns_); }

}  // namespace latticeworld
