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
// Not all of a thousand: nobody reads them.
std::string NamesOf(const WorldState& state) {
  constexpr std::size_t kMost = 50;
  if (state.agents.empty()) return "there are no agents";
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(kMost, state.agents.size()); ++i) {
    names.push_back(state.agents[i].name);
  }
  const std::size_t more = state.agents.size() - names.size();
  return "there are " + Join(names, ", ") +
         (more > 0 ? " and " + std::to_string(more) + " more" : "");
}
Status Stopped() { return Unavailable("world_server is shutting down"); }

}  // namespace

SimulationLoop::SimulationLoop(const SimulationLoopOptions& options, SimulationListener* listener)
    : options_(options),
      listener_(listener),
      step_ns_(static_cast<std::uint64_t>(std::llround(options.step_s * 1e9))),
      paused_(options.start_paused) {}

SimulationLoop::~SimulationLoop() { Stop(); }

void SimulationLoop::Start() {
  thread_ = std::thread([this] { Run(); });
}

void SimulationLoop::Stop() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

bool SimulationLoop::Post(std::function<void()> task) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (stopping_) return false;
    tasks_.push_back(std::move(task));
  }
  wake_.notify_all();
  return true;
}

template <typename T>
Result<T> SimulationLoop::Call(std::function<Result<T>()> task) {
  // The promise is shared, for the task may outlive this call's stack when the loop stops.
  auto promise = std::make_shared<std::promise<Result<T>>>();
  std::future<Result<T>> answer = promise->get_future();
  // Nothing but the queue may keep the promise while this call waits, else Stop cannot break it.
  const bool posted = Post([promise, task] {
    try {
      promise->set_value(task());
    } catch (...) {  // the caller's, who asked for it; the loop goes on
      promise->set_exception(std::current_exception());
    }
  });
  promise.reset();
  if (!posted) return Stopped();
  try {
    return answer.get();
  } catch (const std::future_error&) {  // dropped by Stop
    return Stopped();
  } catch (const std::exception& error) {  // of the task: memory that ended
    return Internal(error.what());
  }
}

Result<ros::Time> SimulationLoop::Swap(RunningWorld* world) {
  return Call<ros::Time>([this, world]() -> Result<ros::Time> {
    FinishJob(Status(StatusCode::kAborted, "another world has taken the place of this one"));
    std::swap(running_, *world);
    listener_->OnBegin();
    Settle();
    return Now();
  });
}

Result<SimulationLoop::Agent> SimulationLoop::Spawn(const SpawnRequest& request) {
  return Call<Agent>([this, request]() -> Result<Agent> {
    if (running_.simulator == nullptr) return NoWorld();
    LW_ASSIGN_OR_RETURN(const std::string name, running_.simulator->Spawn(request));
    Settle();
    return Agent{name, running_.world->id};
  });
}

Result<SimulationLoop::Agent> SimulationLoop::Remove(const std::string& name) {
  return Call<Agent>([this, name]() -> Result<Agent> {
    if (running_.simulator == nullptr) return NoWorld();
    const Status removed = running_.simulator->Remove(name);
    if (removed.code() == StatusCode::kNotFound) {
      return NotFound(removed.message() + "; " + NamesOf(*running_.simulator->State()));
    }
    LW_RETURN_IF_ERROR(removed);
    Settle();
    return Agent{name, running_.world->id};
  });
}

Result<SimulationLoop::WeatherAnswer> SimulationLoop::SetWeather(const WeatherChange& change) {
  return Call<WeatherAnswer>([this, change]() -> Result<WeatherAnswer> {
    if (running_.simulator == nullptr) return NoWorld();
    LW_RETURN_IF_ERROR(running_.simulator->SetWeather(change));
    Settle();
    return WeatherAnswer{running_.world->id, Now(), running_.simulator->WeatherTarget()};
  });
}

void SimulationLoop::Command(const std::string& agent, const VelocityCommand& command) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    // Nobody waits: once the loop has stopped there is no robot to drive.
    if (stopping_) return;
    const bool on_its_way = !commands_.empty();
    commands_[agent] = command;
    if (on_its_way) return;
    tasks_.push_back([this] { RunCommands(); });
  }
  wake_.notify_all();
}

void SimulationLoop::RunCommands() {
  std::map<std::string, VelocityCommand> commands;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    commands.swap(commands_);
  }
  if (running_.simulator == nullptr) return;
  for (const auto& [agent, command] : commands) {
    const Status status = running_.simulator->Command(agent, command);
    if (!status.ok()) {
      ROS_WARN_STREAM_THROTTLE(1.0, "cmd_vel of " << agent << ": " << status.ToString());
    }
  }
}

Result<SimulationLoop::Snapshot> SimulationLoop::Inspect(bool hash) {
  return Call<Snapshot>([this, hash]() -> Result<Snapshot> {
    if (running_.simulator == nullptr) return NoWorld();
    return Look(hash);
  });
}

Result<SimulationLoop::Snapshot> SimulationLoop::Reset(std::uint64_t seed) {
  return Call<Snapshot>([this, seed]() -> Result<Snapshot> {
    if (running_.simulator == nullptr) return NoWorld();
    FinishJob(Status(StatusCode::kAborted, "the world was reset"));
    running_.simulator->Reset(seed != 0 ? seed : running_.simulator->seed());
    listener_->OnBegin();
    Settle();
    return Look(true);
  });
}

Result<SimulationLoop::Snapshot> SimulationLoop::Step(std::uint32_t steps, bool hash) {
  if (steps < 1 || steps > kMaxStepsPerCall) {
    return Status(StatusCode::kOutOfRange, std::to_string(steps) +
                                               " steps are not legal; legal "
                                               "are 1 .. " +
                                               std::to_string(kMaxStepsPerCall));
  }
  auto promise = std::make_shared<std::promise<Result<Snapshot>>>();
  std::future<Result<Snapshot>> answer = promise->get_future();
  const bool posted = Post([this, steps, hash, promise] {
    if (running_.simulator == nullptr) {
      promise->set_value(NoWorld());
    } else if (!paused_) {
      promise->set_value(FailedPrecondition("the simulation is running; call pause first"));
    } else if (job_) {
      promise->set_value(ResourceExhausted("another step call is not done yet"));
    } else {
      job_ = StepJob{steps, hash, [promise](Result<Snapshot> snapshot) {
                       promise->set_value(std::move(snapshot));
                     }};
    }
  });
  promise.reset();
  if (!posted) return Stopped();
  try {
    return answer.get();
  } catch (const std::future_error&) {  // dropped by Stop
    return Stopped();
  }
}

Status SimulationLoop::SetPaused(bool paused) {
  return Call<bool>([this, paused]() -> Result<bool> {
           const bool cut_short = job_.has_value();
           FinishJob(
               Status(StatusCode::kAborted, paused ? "paused meanwhile" : "unpaused meanwhile"));
           const bool changed = paused != paused_;
           paused_ = paused;
           if (changed) next_due_ = Clock::now();
           if (paused && (changed || cut_short)) Settle();
           return true;
         })
      .status();
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
      if (last) FinishJob(Status());
    } else if (paused_) {
      listener_->OnStandstill(Now());
      if (!WaitUntil(Clock::now() + kStandstillPeriod)) break;
      next_due_ = Clock::now();
    } else {
      Advance(false);
      Pace();
    }
  }
  // Whoever waits for a task or a job hears, by its broken promise, that none will come.
  std::deque<std::function<void()>> dropped;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    dropped.swap(tasks_);
  }
  job_.reset();
}

void SimulationLoop::RunTasks() {
  std::deque<std::function<void()>> tasks;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    tasks.swap(tasks_);
  }
  for (const std::function<void()>& task : tasks) task();
}

bool SimulationLoop::WaitUntil(Clock::time_point due) {
  for (;;) {
    {
      std::unique_lock<std::mutex> lock(mutex_);
      wake_.wait_until(lock, due, [this] { return stopping_ || !tasks_.empty(); });
      if (stopping_) return false;
      if (tasks_.empty()) return true;
    }
    RunTasks();
    // Lockstep does not wait, and neither does time for those who ask without end.
    if (job_ || Clock::now() >= due) return true;
  }
}

void SimulationLoop::Pace() {
  // Without a world there is nothing to hurry for.
  const double factor = options_.real_time_factor > 0.0 ? options_.real_time_factor
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
    running_.simulator->Step();
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

SimulationLoop::Snapshot SimulationLoop::Look(bool hash) const {
  const std::shared_ptr<const WorldState> state = running_.simulator->State();
  Snapshot snapshot;
  snapshot.world = running_.world;
  snapshot.now = Now();
  snapshot.seed = running_.simulator->seed();
  snapshot.step = state->step;
  snapshot.episode_step = state->episode_step;
  snapshot.paused = paused_;
  snapshot.atmosphere = state->atmosphere;
  if (hash) snapshot.state_hash = running_.simulator->StateHash();
  return snapshot;
}

void SimulationLoop::TellStatistics() {
  const Clock::time_point now = Clock::now();
  const double wall_s = std::chrono::duration<double>(now - statistics_begin_).count();
  if (now - statistics_begin_ < kStatisticsPeriod) return;
  LoopStatistics statistics;
  statistics.now = Now();
  statistics.paused = paused_;
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
