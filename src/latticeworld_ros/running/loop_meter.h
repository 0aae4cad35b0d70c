#ifndef LATTICEWORLD_ROS_RUNNING_LOOP_METER_H_
#define LATTICEWORLD_ROS_RUNNING_LOOP_METER_H_

#include <cstdint>

#include "latticeworld_ros/running/loop_clock.h"
#include "latticeworld_ros/running/simulation_listener.h"

namespace latticeworld {

// How fast the simulation loop runs, told about once a second.
class LoopMeter {
 public:
  // step_s: simulated time of an advance.
  LoopMeter(double step_s, LoopClock::TimePoint now) : step_s_(step_s), begin_(now) {}

  // Simulated time went on by one step. What is shown without a step, after a change, counts not.
  void AddAdvance() { ++advances_; }
  // Wall time that the simulator took for one.
  void AddStep(LoopClock::TimePoint::duration took);
  bool IsDue(LoopClock::TimePoint now) const;
  // Fills in what was measured since the last call, and begins anew.
  void Take(LoopClock::TimePoint now, LoopStatistics* statistics);

 private:
  double step_s_;
  LoopClock::TimePoint begin_;
  std::uint64_t advances_ = 0;
  std::uint64_t steps_ = 0;
  double steps_total_s_ = 0.0;
  double steps_max_s_ = 0.0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_RUNNING_LOOP_METER_H_
