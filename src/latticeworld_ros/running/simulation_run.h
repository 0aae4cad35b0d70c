#ifndef LATTICEWORLD_ROS_RUNNING_SIMULATION_RUN_H_
#define LATTICEWORLD_ROS_RUNNING_SIMULATION_RUN_H_

#include <ros/time.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/generation/world.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld_ros/running/agent_commands.h"

namespace latticeworld {

// A world and the simulator that runs it.
struct LaunchedWorld {
  std::shared_ptr<const World> world;
  std::unique_ptr<Simulator> simulator;
};

struct StampedEvent {
  ros::Time stamp;
  Event event;
};

// The running world, between two steps.
struct SimulationMoment {
  std::shared_ptr<const World> world;
  ros::Time now;
  std::uint64_t seed = 0;     // of the simulation
  std::uint64_t episode = 0;  // another one after every reset, restored snapshot and new world
  std::uint64_t step = 0;
  std::uint64_t episode_step = 0;
  std::shared_ptr<const WorldState> state;
  std::vector<StampedEvent> events;  // since a call of Step began; of other calls none
  bool paused = false;
  std::string state_hash;  // empty: not asked for
  Atmosphere atmosphere;
  std::vector<std::string> snapshots;  // names, sorted
  std::shared_ptr<const SpeciesCatalogue> species;
};

// Most snapshots that are kept, and characters of their names.
inline constexpr std::size_t kMaxSnapshots = 8;
inline constexpr std::size_t kMaxSnapshotName = 64;

// The running world, its snapshots, and whether its simulator can be trusted. An exception out of a
// call that changes the simulator may leave it half changed. It has failed then: nobody gets to see
// or to step it until Reset, Restore or Swap give it a whole state again. Not thread safe.
class SimulationRun {
 public:
  const std::shared_ptr<const World>& world() const { return running_.world; }  // null: none yet
  // Null: there is no world, or its simulator has failed.
  Simulator* simulator() const { return failure_.empty() ? running_.simulator.get() : nullptr; }
  // Why the simulator cannot go on; empty: it can.
  const std::string& failure() const { return failure_; }
  // Returns the number of the running episode, as a moment has it.
  std::uint64_t episode() const { return episode_; }
  // FAILED_PRECONDITION: there is no world, or its simulator has failed.
  Status Check() const;

  // Runs *world; *world gets the one before (or none). Snapshots of that one are gone.
  void Swap(LaunchedWorld* world);

  // Each of these: FAILED_PRECONDITION as Check, except for Reset and Restore, which a failed
  // simulator gets over; INTERNAL: it failed.

  Status Step();
  // Also: the errors of `change`, which answers the name of what it changed.
  Result<std::string> Apply(const std::function<Result<std::string>(Simulator*)>& change);
  Status SetWeather(const WeatherChange& change);
  // Gives the waiting commands to the simulator, or to nobody while there is none or it has failed.
  void Command(AgentCommands* commands);
  // seed 0: the one that it runs with.
  Status Reset(std::uint64_t seed);
  // Saves the state in the place of one that has the name. Also: INVALID_ARGUMENT (name),
  // RESOURCE_EXHAUSTED.
  Status Save(const std::string& name);
  // Also: NOT_FOUND naming those that there are.
  Status Restore(const std::string& name);

  // All but the loop's own time and pause. Check is OK.
  SimulationMoment Look(bool hash) const;

 private:
  // Does what changes the simulator. doing: "in a step".
  Status Guard(const std::string& doing, const std::function<Status()>& change);
  std::vector<std::string> SnapshotNames() const;

  LaunchedWorld running_;
  std::string failure_;
  std::uint64_t episode_ = 0;
  std::map<std::string, std::shared_ptr<const SimulatorSnapshot>> snapshots_;  // of running_
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_RUNNING_SIMULATION_RUN_H_
