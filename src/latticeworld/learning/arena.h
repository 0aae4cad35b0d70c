#ifndef LATTICEWORLD_LEARNING_ARENA_H_
#define LATTICEWORLD_LEARNING_ARENA_H_

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/geo_origin.h"
#include "latticeworld/sensing/sensor_rig.h"
#include "latticeworld/simulation/simulator.h"

namespace latticeworld {

struct Scene;

struct ArenaOptions {
  SimulatorOptions simulator;  // physics_threads: 1 where many arenas are advanced side by side
  std::shared_ptr<const SensorSuite> sensors;  // whose first 2D lidar robots carry; null: none
  GeoOrigin origin;
};

// A world that is advanced call by call, and the scans of its robots, as the service lockstep of
// world_server has them: same world, options, seed and calls, same states and scans, bit for bit.
// Only those sweeps of a call are traced that can be the last one of this call or the next. One
// thread at a time; arenas know nothing of each other.
class Arena {
 public:
  // Errors: INVALID_ARGUMENT (options; a suite without a 2D lidar).
  static Result<std::unique_ptr<Arena>> Create(std::shared_ptr<const Scene> scene,
                                               const ArenaOptions& options, std::uint64_t seed);

  // The simulator is for commands, spawning and looking; steps, resets and restores go through the
  // arena.
  Simulator* simulator() { return simulator_.get(); }
  const Simulator& simulator() const { return *simulator_; }
  const LidarModel* scanner() const;  // null: robots have none
  double scan_rate_hz() const;        // of a scanner

  void Reset(std::uint64_t seed);
  // Errors: INVALID_ARGUMENT (of another scene or other options).
  Status Restore(const SimulatorSnapshot& snapshot);

  // Advances by so many fixed steps. scanned: the robots whose sweeps are kept. check: asked now
  // and then whether to go on. Errors: its own, and Embree's: the state has moved on and there are
  // no sweeps then.
  Status Advance(int steps, const std::vector<std::string>& scanned,
                 const std::function<Status()>& check = nullptr);

  // The last one that was complete at or before the last step; null: none of a robot that the last
  // Advance scanned.
  const LidarSweep* SweepOf(const std::string& robot) const;
  // Returns the events of the steps of the last Advance.
  const std::vector<Event>& events() const { return events_; }

 private:
  Arena(std::shared_ptr<const SensorSuite> scanner, std::unique_ptr<Simulator> simulator,
        std::unique_ptr<SensorRig> rig);

  // The first step of those up to `last` at which a sweep is in progress that can be the last one
  // of this call or the next; in steps of the episode. Before it nobody has to sense.
  std::uint64_t FirstScannedStep(std::uint64_t last) const;
  Status Go(int steps, bool senses, const std::function<Status()>& check);
  Status Sense(std::uint64_t first_scanned);
  void RestartRig();

  std::shared_ptr<const SensorSuite> scanner_;  // of that one sensor; null: none
  std::unique_ptr<Simulator> simulator_;
  std::unique_ptr<SensorRig> rig_;  // null: no scanner
  bool senses_ = false;             // the last step was sensed
  std::vector<std::string> scanned_;
  std::map<std::string, LidarSweep> sweeps_;  // by robot
  std::vector<Event> events_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LEARNING_ARENA_H_
