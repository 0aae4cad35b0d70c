#include "latticeworld_ros/running/simulation_loop.h"

#include <ros/console.h>

#include <cmath>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld_ros/node/guarded.h"

namespace latticeworld {
namespace {

constexpr std::chrono::milliseconds kStandstillPeriod(100);
// Further behind than this the loop gives up the lost time instead of running after it.
constexpr std::chrono::milliseconds kMaxLag(100);

Status Aborted(const char* why) { return Status(StatusCode::kAborted, why); }

}  // namespace

Status CheckRealTimeFactor(double factor) {
  if (factor == 0.0 || (factor >= 0.01 && factor <= 1000.0)) return Status();
  return Status(StatusCode::kOutOfRange, "factor is " + FormatDouble(factor) +
                                             "; legal is 0 (as fast as possible) or 0.01 .. 1000");
}

SimulationLoop::SimulationLoop(const SimulationLoopOptions& options, SimulationListener* listener,
                               std::unique_ptr<LoopClock> clock)
    : options_(options),
      listener_(listener),
      clock_(std::move(clock)),
      step_ns_(static_cast<std::uint64_t>(std::llround(options.step_s * 1e9))),
      tasks_(clock_.get(), Unavailable("world_server is shutting down")),
      paused_(options.start_paused),
      real_time_factor_(options.real_time_factor),
      meter_(options.step_s, clock_->Now()) {}

SimulationLoop::~SimulationLoop() { Stop(); }

void SimulationLoop::Start() {
  thread_ = std::thread([this] { Run(); });
}

void SimulationLoop::Stop() {
  tasks_.Stop();
  if (thread_.joinable()) thread_.join();
}

Result<ros::Time> SimulationLoop::Swap(LaunchedWorld* world) {
  return tasks_.Call<ros::Time>([this, world]() -> Result<ros::Time> {
    FinishJob(Aborted("another world has taken the place of this one"));
    run_.Swap(world);
    Tell([this] { listener_->OnBegin(); });
    Settle();
    return Now();
  });
}

Result<SimulationLoop::Change> SimulationLoop::Apply(
    const std::function<Result<std::string>(Simulator*)>& change) {
  return tasks_.Call<Change>([this, change]() -> Result<Change> {
    LW_ASSIGN_OR_RETURN(const std::string name, run_.Apply(change));
    Settle();
    return Change{name, run_.world()->id};
  });
}

Result<SimulationLoop::WeatherAnswer> SimulationLoop::SetWeather(const WeatherChange& change) {
  return tasks_.Call<WeatherAnswer>([this, change]() -> Result<WeatherAnswer> {
    LW_RETURN_IF_ERROR(run_.SetWeather(change));
    Settle();
    return WeatherAnswer{run_.world()->id, Now(), run_.simulator()->WeatherTarget()};
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
  (void)tasks_.Post([this] { run_.Command(&commands_); });
}

Result<SimulationLoop::Moment> SimulationLoop::Inspect(bool hash) {
  return tasks_.Call<Moment>([this, hash]() -> Result<Moment> {
    LW_RETURN_IF_ERROR(run_.Check());
    return Look(hash);
  });
}

Result<SimulationLoop::Moment> SimulationLoop::Reset(std::uint64_t seed) {
  return tasks_.Call<Moment>([this, seed]() -> Result<Moment> {
    FinishJob(Aborted("the world was reset"));
    LW_RETURN_IF_ERROR(run_.Reset(seed));
    Tell([this] { listener_->OnBegin(); });
    Settle();
    return Look(true);
  });
}

Result<SimulationLoop::Moment> SimulationLoop::Step(std::uint32_t steps, bool hash) {
  StepCall call;
  call.steps = steps;
  call.hash = hash;
  return Step(call);
}

Result<SimulationLoop::Moment> SimulationLoop::Step(const StepCall& call) {
  if (call.steps < 1 || call.steps > kMaxStepsPerCall) {
    return Status(StatusCode::kOutOfRange, std::to_string(call.steps) +
                                               " steps are not legal; legal are 1 .. " +
                                               std::to_string(kMaxStepsPerCall));
  }
  return tasks_.CallLater<Moment>([this, call](auto promise) {
    Status status = run_.Check();
    if (!status.ok()) {
      promise->set_value(status);
    } else if (!paused_) {
      promise->set_value(FailedPrecondition("the simulation is running; call pause first"));
    } else if (call.episode != 0 && call.episode != run_.episode()) {
      promise->set_value(FailedPrecondition(
          "episode " + std::to_string(call.episode) + " is over and episode " +
          std::to_string(run_.episode()) +
          " runs: another client has reset the world, restored a snapshot or started another "
          "world; learning environments that live at the same time run in process, or with a "
          "server and a process each (docs/learning.md)"));
    } else if (job_) {
      promise->set_value(ResourceExhausted("another step call is not done yet"));
    } else {
      if (call.begin != nullptr) {
        const auto begin = [&call](Simulator* simulator) -> Result<std::string> {
          LW_RETURN_IF_ERROR(call.begin(simulator));
          return std::string();
        };
        status = run_.Apply(begin).status();
      }
      if (status.ok()) {
        job_ = StepJob{call.steps, call.hash, call.end, std::move(promise), {}};
      } else {
        promise->set_value(status);
      }
    }
  });
}

Status SimulationLoop::SetPaused(bool paused) {
  return tasks_
      .Call<bool>([this, paused]() -> Result<bool> {
        const bool cut_short = job_.has_value();
        FinishJob(Aborted(paused ? "paused meanwhile" : "unpaused meanwhile"));
        const bool changed = paused != paused_;
        paused_ = paused;
        if (changed) next_due_ = clock_->Now();
        if (paused && (changed || cut_short)) Settle();
        return true;
      })
      .status();
}

Result<double> SimulationLoop::SetRealTimeFactor(double factor) {
  LW_RETURN_IF_ERROR(CheckRealTimeFactor(factor));
  return tasks_.Call<double>([this, factor]() -> Result<double> {
    next_due_ = clock_->Now();
    return std::exchange(real_time_factor_, factor);
  });
}

Result<SimulationLoop::Moment> SimulationLoop::SaveSnapshot(const std::string& name) {
  return tasks_.Call<Moment>([this, name]() -> Result<Moment> {
    LW_RETURN_IF_ERROR(run_.Save(name));
    return Look(true);
  });
}

Result<SimulationLoop::Moment> SimulationLoop::RestoreSnapshot(const std::string& name) {
  return tasks_.Call<Moment>([this, name]() -> Result<Moment> {
    LW_RETURN_IF_ERROR(run_.Restore(name));
    FinishJob(Aborted("a snapshot was restored"));
    Tell([this] { listener_->OnRestore(); });
    Settle();
    return Look(true);
  });
}

void SimulationLoop::Run() {
  next_due_ = clock_->Now();
  Settle();
  for (;;) {
    if (!WaitUntil(clock_->Now())) break;
    TellStatistics();
    if (job_) {
      const bool last = --job_->left == 0;
      const Status advanced = Advance(last);
      if (!advanced.ok()) {
        FinishJob(Internal(advanced.message()));
      } else if (last) {
        FinishJob(Status());
      }
    } else if (paused_ || !run_.failure().empty()) {
      Tell([this] { listener_->OnStandstill(Now()); });
      if (!WaitUntil(clock_->Now() + kStandstillPeriod)) break;
      next_due_ = clock_->Now();
    } else {
      (void)Advance(false);  // a failure shows at the next turn
      Pace();
    }
  }
  // Whoever waits hears that nothing will come.
  tasks_.Drop();
  job_.reset();
}

bool SimulationLoop::WaitUntil(TimePoint due) {
  // Lockstep does not wait.
  return tasks_.WaitUntil(due, [this] { return job_.has_value(); });
}

void SimulationLoop::Pace() {
  // Without a world there is nothing to hurry for.
  const double factor = real_time_factor_ > 0.0   ? real_time_factor_
                        : run_.world() == nullptr ? 1.0
                                                  : 0.0;
  const TimePoint now = clock_->Now();
  if (factor == 0.0) {
    next_due_ = now;
    return;
  }
  next_due_ += std::chrono::nanoseconds(std::llround(static_cast<double>(step_ns_) / factor));
  if (now - next_due_ > kMaxLag) next_due_ = now;
  if (next_due_ > now) (void)WaitUntil(next_due_);  // a stop is seen at the top of Run
}

Status SimulationLoop::Advance(bool settled) {
  if (run_.world() != nullptr) {
    const TimePoint begin = clock_->Now();
    LW_RETURN_IF_ERROR(run_.Step());
    meter_.AddStep(clock_->Now() - begin);
  }
  meter_.AddAdvance();
  ShowTick(settled);
  return Status();
}

void SimulationLoop::ShowTick(bool settled) {
  ++tick_;
  Tick tick{tick_, Now(), run_.simulator(), run_.world(), settled, paused_, {}};
  if (tick.simulator != nullptr) tick.events = tick.simulator->TakeEvents();
  if (job_) {
    for (const Event& event : tick.events) job_->events.push_back({tick.now, event});
  }
  Tell([&] { listener_->OnTick(tick); });
}

void SimulationLoop::Tell(const std::function<void()>& tell) {
  const std::optional<std::string> words = ExceptionOf(tell);
  if (words.has_value()) ROS_ERROR_STREAM_THROTTLE(1.0, "not published: " << *words);
}

void SimulationLoop::FinishJob(const Status& status) {
  if (!job_) return;
  const StepJob job = std::move(*job_);
  job_.reset();
  std::optional<Moment> moment;
  const std::optional<std::string> words = ExceptionOf([&] {
    if (!status.ok()) return;
    moment = Look(job.hash);
    moment->events = job.events;
    if (job.end != nullptr) job.end();
  });
  if (words.has_value()) {
    job.answer->set_value(Internal(*words));
  } else if (moment.has_value()) {
    job.answer->set_value(*std::move(moment));
  } else {
    job.answer->set_value(status);
  }
}

SimulationLoop::Moment SimulationLoop::Look(bool hash) const {
  Moment moment = run_.Look(hash);
  moment.now = Now();
  moment.paused = paused_;
  return moment;
}

void SimulationLoop::TellStatistics() {
  const TimePoint now = clock_->Now();
  if (!meter_.IsDue(now)) return;
  LoopStatistics statistics;
  statistics.now = Now();
  statistics.paused = paused_;
  statistics.failure = run_.failure();
  statistics.wanted_factor = real_time_factor_;
  statistics.simulator = run_.simulator();
  statistics.world = run_.world();
  meter_.Take(now, &statistics);
  Tell([&] { listener_->OnStatistics(statistics); });
}

ros::Time SimulationLoop::Now() const { return ros::Time().fromNSec(tick_ * step_ns_); }

}  // namespace latticeworld
