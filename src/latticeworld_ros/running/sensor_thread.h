#ifndef LATTICEWORLD_ROS_RUNNING_SENSOR_THREAD_H_
#define LATTICEWORLD_ROS_RUNNING_SENSOR_THREAD_H_

#include <ros/time.h>
#include <sensor_msgs/LaserScan.h>

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include "latticeworld/generation/world.h"
#include "latticeworld/sensing/sensor_rig.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld_ros/conversion/point_times.h"
#include "latticeworld_ros/publishing/sensor_topics.h"
#include "latticeworld_ros/running/simulation_listener.h"

namespace latticeworld {

struct SensorThreadOptions {
  int threads = 1;                               // that trace rays
  std::uint64_t seed = 0;                        // of all noise; 0: of the simulation's
  double longitude_deg = 9.0, altitude_m = 0.0;  // of worlds that lie nowhere on the earth
  double geoid_undulation_m = 0.0;               // of the data's datum above the ellipsoid, there
  PointTimes point_times = PointTimes::kEnd;     // of clouds
};

// Returns where the origin of a world's map lies for its sensors, as WGS 84 has it: the altitude of
// z = 0 is above the ellipsoid, as NavSatFix means it.
GeoOrigin OriginForSensors(const World& world, const SensorThreadOptions& options);

// What the sensors did since the node began.
struct SensorStatistics {
  int listeners = 0;         // of all sensors' topics together, now
  std::uint64_t steps = 0;   // of the simulation that sensors looked at
  std::uint64_t frames = 0;  // that were made and published
  double busy_s = 0.0;       // wall time of both
};

// Makes and publishes what the robots of the running world sense, on a thread of its own, one
// simulated step after the other. While nobody wants anything of any sensor nothing is done. The
// simulation hands over every step and waits while a few of them are not done yet, so that nothing
// is ever left out: rates in simulated time are exact, and what is more than the machine can do
// slows the simulation down. Frames carry the time of their own moment; /clock must have shown the
// step's time before it is handed over.
class SensorThread {
 public:
  // topics: outlives the thread.
  SensorThread(const SensorThreadOptions& options, SensorTopics* topics);
  ~SensorThread();
  SensorThread(const SensorThread&) = delete;
  SensorThread& operator=(const SensorThread&) = delete;

  // Whether the suite has a 2D lidar, whose sweeps can be kept. Errors: FAILED_PRECONDITION.
  Status CheckScanner() const;
  // Keeps, while the simulation is paused from here on, the last sweep that the first 2D lidar of
  // each of these agents completes, until a jump or until others are named.
  void KeepScans(std::set<std::string> agents);
  // Returns the kept scan of the agent; null: none is complete yet. It is that of the last step
  // once Take has come back from a settled tick.
  std::shared_ptr<const sensor_msgs::LaserScan> KeptScan(const std::string& agent) const;

  // Returns whether Take will hand something over. For the simulation loop's thread.
  bool IsDue(const Tick& tick) const;
  // Hands over the step that the tick shows. Waits while the queue is full, and, where the tick is
  // settled, until all that is due has been published.
  void Take(const Tick& tick);
  // The next step is no successor of the last one.
  void OnJump();

  SensorStatistics statistics() const;
  // Nobody waits any longer, and nothing is published from here on.
  void Stop();

 private:
  using AgentNames = std::shared_ptr<const std::set<std::string>>;
  // One step of a world.
  struct Moment {
    std::shared_ptr<const World> world;  // null: no step, but the end of what was sensed
    std::shared_ptr<const WorldState> state;
    std::shared_ptr<const SpeciesCatalogue> species;
    double step_s = 0.01;
    ros::Time now;
    std::uint64_t seed = 0;  // of noise
    bool is_beginning = false;
    AgentNames scanned;  // whose sweeps are kept; not null
  };

  // Lets the thread forget a world that has ended, which takes memory.
  void ForgetWorldBefore(const Tick& tick);
  void Run();
  void Sense(const Moment& moment);
  // Makes the sensors of a moment's world, unless they are there. False: they cannot be had.
  bool HasRig(const Moment& moment);
  void ForgetScans(const Moment& moment);
  void Keep(const SensorFrame& frame, ros::Time stamp);

  const SensorThreadOptions options_;
  SensorTopics* const topics_;
  const SensorSpec* const scanner_;  // of the suite; null: it has none

  // Only the loop's thread touches these.
  bool jumped_ = true;
  std::uint64_t last_step_ = 0;          // of the episode, as handed over
  const World* handed_world_ = nullptr;  // which the thread keeps; nullptr: none

  // Only this thread touches these.
  std::shared_ptr<const World> rig_world_;  // of rig_, or of the try to make one
  std::unique_ptr<SensorRig> rig_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Moment> queue_;  // the first is being worked on
  AgentNames scanned_ = std::make_shared<std::set<std::string>>();
  std::map<std::string, std::shared_ptr<const sensor_msgs::LaserScan>> scans_;  // by agent
  SensorStatistics statistics_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_RUNNING_SENSOR_THREAD_H_
