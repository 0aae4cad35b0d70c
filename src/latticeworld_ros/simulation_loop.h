#ifndef LATTICEWORLD_ROS_SIMULATION_LOOP_H_
#define LATTICEWORLD_ROS_SIMULATION_LOOP_H_

#include <ros/time.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/generation/world.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld_ros/agent_commands.h"
#include "latticeworld_ros/simulation_listener.h"
#include "latticeworld_ros/task_queue.h"

namespace latticeworld {

struct SimulationLoopOptions {
  double step_s = 0.01;           // of every simulator that is run
  double real_time_factor = 1.0;  // at the start; 0: as fast as possible
  bool start_paused = false;
};

// A world and the simulator that runs it.
struct RunningWorld {
  std::shared_ptr<const World> world;
  std::unique_ptr<Simulator> simulator;
};

// Most steps that one call of Step may ask for.
inline constexpr std::uint32_t kMaxStepsPerCall = 100000;
// Most snapshots that are kept, and characters of their names.
inline constexpr std::size_t kMaxSnapshots = 8;
inline constexpr std::size_t kMaxSnapshotName = 64;
// OK for 0 (as fast as possible) and 0.01 .. 1000; else OUT_OF_RANGE.
Status CheckRealTimeFactor(double factor);

// The one thread that steps the simulator and owns time. ROS time is a count of fixed steps since
// the node began; it runs without a world too, stands still while paused and never falls, whatever
// worlds and resets come. All else is asked for by other threads and done between two steps; those
// calls block until it is done, and are UNAVAILABLE once the loop has stopped. A simulator that
// throws in a step stands still from then on, until it is reset, restored or replaced.
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

  struct Change {
    std::string name;  // of what was changed
    std::string world_id;
  };
  struct WeatherAnswer {
    std::string world_id;
    ros::Time now;
    Atmosphere target;  // once the change is complete
  };
  // Does something to the running simulator, which answers the name of what was changed, and shows
  // it at once. Errors: FAILED_PRECONDITION (no world), those of the change.
  Result<Change> Apply(const std::function<Result<std::string>(Simulator*)>& change);
  // Errors: FAILED_PRECONDITION (no world), INVALID_ARGUMENT with every violation.
  Result<WeatherAnswer> SetWeather(const WeatherChange& change);
  // These do not block; AgentCommands says what becomes of several between two steps.
  void Command(const std::string& agent, const VelocityCommand& command);
  void CommandJoints(const std::string& agent, std::vector<JointCommand> commands);
  void Strike(const std::string& agent);

  // The running world, between two steps.
  struct Moment {
    std::shared_ptr<const World> world;
    ros::Time now;
    std::uint64_t seed = 0;  // of the simulation
    std::uint64_t step = 0;
    std::uint64_t episode_step = 0;
    bool paused = false;
    std::string state_hash;  // empty: not asked for
    Atmosphere atmosphere;
    std::vector<std::string> snapshots;  // names, sorted
    std::shared_ptr<const SpeciesCatalogue> species;
  };
  // FAILED_PRECONDITION while there is no world.
  Result<Moment> Inspect(bool hash);
  // seed 0: the one that it runs with.
  Result<Moment> Reset(std::uint64_t seed);
  // steps: 1 .. kMaxStepsPerCall. Errors: FAILED_PRECONDITION (running, no world), OUT_OF_RANGE,
  // RESOURCE_EXHAUSTED (another Step is not done), ABORTED (Swap, Reset or SetPaused came between).
  Result<Moment> Step(std::uint32_t steps, bool hash);
  Status SetPaused(bool paused);
  // Answers the factor before. Errors: OUT_OF_RANGE.
  Result<double> SetRealTimeFactor(double factor);
  // Keeps the state under a name, in the place of one that has it already; another world drops all.
  // Errors: FAILED_PRECONDITION (no world), INVALID_ARGUMENT (name), RESOURCE_EXHAUSTED.
  Result<Moment> SaveSnapshot(const std::string& name);
  // Errors: FAILED_PRECONDITION (no world), NOT_FOUND naming those that there are.
  Result<Moment> RestoreSnapshot(const std::string& name);

 private:
  using Clock = TaskQueue::Clock;
  // A call of Step that is not done yet.
  struct StepJob {
    std::uint32_t left = 0;
    bool hash = false;
    std::function<void(Result<Moment>)> done;
  };

  void Run();
  // Lets the loop give the waiting commands to the simulator.
  void PostCommands();
  // Waits until `due` and runs tasks meanwhile. False: the loop is to stop.
  bool WaitUntil(const Clock::time_point& due);
  void Pace();
  // One fixed step. settled: the last one for a while.
  void Advance(bool settled);
  // Shows a change that no step made.
  void Settle();
  // Answers the call of Step that waits, if one does; OK: with the moment.
  void FinishJob(Status status);
  Moment Look(bool hash) const;
  void TellStatistics();
  ros::Time Now() const;

  const SimulationLoopOptions options_;
  SimulationListener* const listener_;
  const std::uint64_t step_ns_;

  TaskQueue tasks_;
  AgentCommands commands_;
  std::thread thread_;

  // Of the loop's thread alone.
  RunningWorld running_;
  std::uint64_t tick_ = 0;
  bool paused_;
  double real_time_factor_;
  std::string failure_;  // of the simulator's last step; empty: it went well
  std::map<std::string, std::shared_ptr<const SimulatorSnapshot>> snapshots_;  // of running_
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
