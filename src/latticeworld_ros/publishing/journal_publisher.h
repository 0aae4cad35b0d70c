#ifndef LATTICEWORLD_ROS_PUBLISHING_JOURNAL_PUBLISHER_H_
#define LATTICEWORLD_ROS_PUBLISHING_JOURNAL_PUBLISHER_H_

#include <ros/ros.h>

#include <cstdint>

#include "latticeworld_ros/running/simulation_listener.h"

namespace latticeworld {

// Publishes what a simulation comes of, where it keeps a journal: world/journal, every call that
// changed it, and world/state_hash, while somebody listens: at its rate, with every settled tick
// and after a reset. Everything but the constructor runs on the simulation loop's thread.
class JournalPublisher {
 public:
  // hash_rate_hz: of simulated time; 0: hashes are published with settled ticks alone.
  JournalPublisher(ros::NodeHandle node, double hash_rate_hz, double step_s);

  // Whether Publish has something to say, so that the clock can be told before.
  bool IsDue(const Tick& tick) const;
  void Publish(const Tick& tick);

 private:
  bool IsHashDue(const Tick& tick) const;

  const std::uint64_t steps_per_hash_;  // 0: settled ticks alone
  ros::Publisher journal_, hash_;
  std::uint64_t run_ = 0;  // of the hash that was published last
  std::uint64_t last_hash_step_ = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_PUBLISHING_JOURNAL_PUBLISHER_H_
