#ifndef LATTICEWORLD_ROS_RUNNING_SIMULATION_LISTENER_H_
#define LATTICEWORLD_ROS_RUNNING_SIMULATION_LISTENER_H_

#include <ros/time.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/generation/world.h"
#include "latticeworld/simulation/simulator.h"

namespace latticeworld {

// One advance of ROS time by the simulator's fixed step.
struct Tick {
  std::uint64_t number = 0;  // since the node began; ROS time is number * fixed step
  ros::Time now;
  Simulator* simulator = nullptr;      // null: no world yet, or its simulator has failed
  std::shared_ptr<const World> world;  // null: no world yet
  bool settled = false;  // the next tick may be long in coming: publish what is due later as well
  bool paused = false;   // time goes on for this call of Step alone, or stands still
  std::vector<Event> events;  // since the last tick

  std::string world_id() const { return world == nullptr ? std::string() : world->id; }
};

// Figures of the last second or so of wall time.
struct LoopStatistics {
  ros::Time now;
  bool paused = false;
  std::string failure;            // why the simulation cannot go on; empty: it can
  double wanted_factor = 1.0;     // real-time factor that is asked for; 0: as fast as possible
  double real_time_factor = 0.0;  // simulated over wall time
  double mean_step_s = 0.0;       // wall time of Simulator::Step
  double max_step_s = 0.0;
  Simulator* simulator = nullptr;      // null: no world yet, or its simulator has failed
  std::shared_ptr<const World> world;  // null: no world yet
};

// Hears what the simulation loop does, on the loop's thread. What it throws goes to the log.
class SimulationListener {
 public:
  virtual ~SimulationListener() = default;
  virtual void OnTick(const Tick& tick) = 0;
  // Time stands still; called about ten times a second meanwhile.
  virtual void OnStandstill(ros::Time now) = 0;
  // A new world, or the start state of the old one: the next tick shows it.
  virtual void OnBegin() = 0;
  // An earlier state of the same world: the next tick shows it.
  virtual void OnRestore() = 0;
  virtual void OnStatistics(const LoopStatistics& statistics) = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_RUNNING_SIMULATION_LISTENER_H_
