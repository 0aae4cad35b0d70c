#ifndef LATTICEWORLD_ROS_RUNNING_SIMULATION_LOOP_H_
#define LATTICEWORLD_ROS_RUNNING_SIMULATION_LOOP_H_

#include <ros/time.h>

#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld_ros/node/task_queue.h"
#include "latticeworld_ros/running/agent_commands.h"
#include "latticeworld_ros/running/loop_clock.h"
#include "latticeworld_ros/running/loop_meter.h"
#include "latticeworld_ros/running/simulation_listener.h"
#include "latticeworld_ros/running/simulation_run.h"

namespace latticeworld {

struct SimulationLoopOptions {
  double step_s = 0.01;           // of every simulator that is run
  double real_time_factor = 1.0;  // at the start; 0: as fast as possible
  bool start_paused = false;
};

// Most steps that one call of Step may ask for.
inline constexpr std::uint32_t kMaxStepsPerCall = 100000;
// OK for 0 (as fast as possible) and 0.01 .. 1000; else OUT_OF_RANGE.
Status CheckRealTimeFactor(double factor);

// The one thread that steps the simulator and owns time. ROS time is a count of fixed steps since
// the node began; it runs without a world too, stands still while paused and never falls, whatever
// worlds and resets come. All else is asked for by other threads and done between two steps; those
// calls block until it is done, and are UNAVAILABLE once the loop has stopped. A simulator that
// throws stands still from then on, until it is reset, restored or replaced (SimulationRun):
// meanwhile every call about it but those is FAILED_PRECONDITION, as while there is no world.
class SimulationLoop {
 public:
  using Moment = SimulationMoment;

  // listener: outlives the loop. clock: not null.
  SimulationLoop(const SimulationLoopOptions& options, SimulationListener* listener,
                 std::unique_ptr<LoopClock> clock = std::make_unique<SteadyLoopClock>());
  ~SimulationLoop();
  SimulationLoop(const SimulationLoop&) = delete;
  SimulationLoop& operator=(const SimulationLoop&) = delete;

  void Start();
  void Stop();

  // Runs *world from the next step on; *world gets the one before (or none), for the caller to
  // destroy. The answer is the ROS time at which it began.
  Result<ros::Time> Swap(LaunchedWorld* world);

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
  // it at once. Errors: those of the change; INTERNAL (it threw, and the simulator has failed).
  Result<Change> Apply(const std::function<Result<std::string>(Simulator*)>& change);
  // Errors: INVALID_ARGUMENT with every violation; INTERNAL as above.
  Result<WeatherAnswer> SetWeather(const WeatherChange& change);
  // These do not block; AgentCommands says what becomes of several between two steps.
  void Command(const std::string& agent, const VelocityCommand& command);
  void CommandJoints(const std::string& agent, std::vector<JointCommand> commands);
  void Strike(const std::string& agent);

  // The running world, between two steps.
  Result<Moment> Inspect(bool hash);
  // seed 0: the one that it runs with.
  Result<Moment> Reset(std::uint64_t seed);
  // steps: 1 .. kMaxStepsPerCall. Errors: FAILED_PRECONDITION (running, episode), OUT_OF_RANGE,
  // RESOURCE_EXHAUSTED (another Step is not done), ABORTED (Swap, Reset, RestoreSnapshot or
  // SetPaused came between), INTERNAL (the simulator has failed meanwhile).
  Result<Moment> Step(std::uint32_t steps, bool hash);
  // The same with what is done before and after, on the loop's thread.
  struct StepCall {
    std::uint32_t steps = 1;
    bool hash = false;
    std::uint64_t episode = 0;  // that runs, else the call is refused; 0: any
    // Runs before the first step. An error refuses the call; an exception fails the simulator.
    std::function<Status(Simulator*)> begin;
    // Runs once the listener has heard of the last step; only for calls that succeed.
    std::function<void()> end;
  };
  Result<Moment> Step(const StepCall& call);
  Status SetPaused(bool paused);
  // Answers the factor before. Errors: OUT_OF_RANGE.
  Result<double> SetRealTimeFactor(double factor);
  // Keeps the state under a name, in the place of one that has it already; another world drops all.
  // Errors: INVALID_ARGUMENT (name), RESOURCE_EXHAUSTED.
  Result<Moment> SaveSnapshot(const std::string& name);
  // Errors: NOT_FOUND naming those that there are.
  Result<Moment> RestoreSnapshot(const std::string& name);

 private:
  using TimePoint = LoopClock::TimePoint;
  // A call of Step that is not done yet.
  struct StepJob {
    std::uint32_t left = 0;
    bool hash = false;
    std::function<void()> end;
    std::shared_ptr<std::promise<Result<Moment>>> answer;
    std::vector<StampedEvent> events;
  };

  void Run();
  // Lets the loop give the waiting commands to the simulator.
  void PostCommands();
  // Waits until `due` and runs tasks meanwhile. False: the loop is to stop.
  bool WaitUntil(TimePoint due);
  void Pace();
  // One fixed step. settled: the last one for a while. Errors: the simulator has failed.
  Status Advance(bool settled);
  // Shows a change that no step made, in a tick of its own: two states never share a stamp, for tf
  // would drop the second.
  void Settle() { ShowTick(/*settled=*/true); }
  void ShowTick(bool settled);
  // Lets the listener hear something.
  void Tell(const std::function<void()>& tell);
  void TellStatistics();
  // Answers the call of Step that waits, if one does; OK: with the moment.
  void FinishJob(const Status& status);
  Moment Look(bool hash) const;
  ros::Time Now() const;

  const SimulationLoopOptions options_;
  SimulationListener* const listener_;
  const std::unique_ptr<LoopClock> clock_;
  const std::uint64_t step_ns_;

  TaskQueue tasks_;
  AgentCommands commands_;
  std::thread thread_;

  // Only the loop's thread touches these.
  SimulationRun run_;
  std::uint64_t tick_ = 0;
  bool paused_;
  double real_time_factor_;
  std::optional<StepJob> job_;
  TimePoint next_due_;
  LoopMeter meter_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_RUNNING_SIMULATION_LOOP_H_
