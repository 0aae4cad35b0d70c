#ifndef LATTICEWORLD_ROS_SIMULATION_LOOP_H_
#define LATTICEWORLD_ROS_SIMULATION_LOOP_H_

#include <ros/time.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "latticeworld/common/result.h"
#include "latticeworld/generation/world.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld_ros/simulation_listener.h"

namespace latticeworld {

struct SimulationLoopOptions {
  double step_s = 0.01;           // of every simulator that is run
  double real_time_factor = 1.0;  // 0: as fast as possible
  bool start_paused = false;
};

// A world and the simulator that runs it.
struct RunningWorld {
  std::shared_ptr<const World> world;
  std::unique_ptr<Simulator> simulator;
};

// Most steps that one call of Step may ask for.
inline constexpr std::uint32_t kMaxStepsPerCall = 100000;

// The one thread that steps the simulator and owns time. ROS time is a count of fixed steps since
// the node began; it runs without a world too, stands still while paused and never falls, whatever
// worlds and resets come. All else is asked for by other threads and done between two steps; those
// calls block until it is done, and are UNAVAILABLE once the loop has stopped.
class SimulationLoop {
 public:
  // listener: outlives the loop.
  SimulationLoop(const SimulationLoopOptions& options, SimulationListener* listener);
  ~SimulationLoop();
  SimulationLoop(const SimulationLoop&) = delete;
  SimulationLoop& operator=(const SimulationLoop&) = delete;

  void Start();
  void Stop();

  // Runs *world from the next step on; *world gets the one before (or none), for the caller to
  // destroy. The answer is the ROS time at which it began.
  Result<ros::Time> Swap(RunningWorld* world);

  struct Agent {
    std::string name;
    std::string world_id;
  };
  struct WeatherAnswer {
    std::string world_id;
    ros::Time now;
    Atmosphere target;  // once the change is complete
  };
  Result<Agent> Spawn(const SpawnRequest& request);
  Result<Agent> Remove(const std::string& name);
  // Errors: FAILED_PRECONDITION (no world), INVALID_ARGUMENT with every violation.
  Result<WeatherAnswer> SetWeather(const WeatherChange& change);
  // Does not block; what comes of it goes to the log. Of several commands to one agent between two
  // steps only the last counts.
  void Command(const std::string& agent, const VelocityCommand& command);

  struct Snapshot {
    std::shared_ptr<const World> world;
    ros::Time now;
    std::uint64_t seed = 0;  // of the simulation
    std::uint64_t step = 0;
    std::uint64_t episode_step = 0;
    bool paused = false;
    std::string state_hash;  // empty: not asked for
    Atmosphere atmosphere;   // of the moment
  };
  // FAILED_PRECONDITION while there is no world.
  Result<Snapshot> Inspect(bool hash);
  // seed 0: the one that it runs with.
  Result<Snapshot> Reset(std::uint64_t seed);
  // steps: 1 .. kMaxStepsPerCall. Errors: FAILED_PRECONDITION (running, no world), OUT_OF_RANGE,
  // RESOURCE_EXHAUSTED (another Step is not done), ABORTED (Swap, Reset or SetPaused came between).
  Result<Snapshot> Step(std::uint32_t steps, bool hash);
  Status SetPaused(bool paused);

 private:
  using Clock = std::chrono::steady_clock;
  // A call of Step that is not done yet.
  struct StepJob {
    std::uint32_t left = 0;
    bool hash = false;
    std::function<void(Result<Snapshot>)> done;
  };

  // Runs `task` on the loop's thread. False: the loop has stopped, the task will not run.
  bool Post(std::function<void()> task);
  // The same, and waits for its answer.
  template <typename T>
  Result<T> Call(std::function<Result<T>()> task);

  void Run();
  void RunTasks();
  void RunCommands();
  // Waits until `due` and runs tasks meanwhile, but not for ever. False: the loop is to stop.
  bool WaitUntil(Clock::time_point due);
  void Pace();
  // One fixed step. settled: the last one for a while.
  void Advance(bool settled);
  // Shows a change that no step made.
  void Settle();
  // Answers the call of Step that waits, if one does; OK: with a snapshot.
  void FinishJob(Status status);
  Snapshot Look(bool hash) const;
  void TellStatistics();
  ros::Time Now() const;

  const SimulationLoopOptions options_;
  SimulationListener* const listener_;
  const std::uint64_t step_ns_;

  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<std::function<void()>> tasks_;          // guarded by mutex_
  std::map<std::string, VelocityCommand> commands_;  // guarded by mutex_; newest of each agent
  bool stopping_ = false;                            // guarded by mutex_
  std::thread thread_;

  // Of the loop's thread alone.
  RunningWorld running_;
  std::uint64_t tick_ = 0;
  bool paused_;
  std::optional<StepJob> job_;
  Clock::time_point next_due_;
  Clock::time_point statistics_begin_;
  std::uint64_t statistics_tick_ = 0;
  std::uint64_t steps_timed_ = 0;
  double steps_total_s_ = 0.0;
  double steps_max_s_ = 0.0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_SIMULATION_LOOP_H_
