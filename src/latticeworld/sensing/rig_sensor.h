#ifndef LATTICEWORLD_SENSING_RIG_SENSOR_H_
#define LATTICEWORLD_SENSING_RIG_SENSOR_H_

#include <cstdint>
#include <memory>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/sensing/rig_world.h"
#include "latticeworld/sensing/sensor_rig.h"

namespace latticeworld {

// Says when a sensor is read: reading k at time k / rate, taken at the first step at or after it;
// if there are several within one step, the last.
class SensorClock {
 public:
  explicit SensorClock(double rate_hz) : rate_hz_(rate_hz) {}

  // Returns the number of the last reading at or before a step's time.
  std::uint64_t Number(std::uint64_t step, double step_s) const;
  bool IsDue(std::uint64_t step, double step_s) const {
    return step == 0 || Number(step, step_s) > Number(step - 1, step_s);
  }

 private:
  double rate_hz_;
};

// One step as a robot's sensors have it. Steps of several robots run at the same time.
struct RigStep {
  RigWorld* shared = nullptr;
  const SensedAgent* agent = nullptr;
  std::uint32_t agent_index = 0;        // in the world's list
  const SensedAgent* before = nullptr;  // the agent one step before; null: this is a beginning
  double step_s = 0.0;
  int threads = 1;  // that trace the rays of one sensor
};

// A sensor of a robot, which is told of every step.
class RigSensor {
 public:
  virtual ~RigSensor() = default;
  // Adds the readings that are complete with this step and wanted. Errors are Embree's.
  virtual Status Step(const RigStep& step, const SensorWish& wish,
                      std::vector<SensorFrame>* frames) = 0;
  // Whether readings are of what lies between them, so that no step must be missed.
  virtual bool IsCollecting() const = 0;
  // Makes it as if it had just been made for an agent of the same height; false: it has to be made.
  virtual bool Forget() { return false; }
};

// seed: of the rig.
std::unique_ptr<RigSensor> MakeRigSensor(std::shared_ptr<const SensorSpec> spec,
                                         const SensedAgent& agent, std::uint64_t seed,
                                         const SensorRigOptions& options);

// MakeRigSensor calls these two for sensors that trace rays. key: of their noise.
std::unique_ptr<RigSensor> MakeRigLidar(std::shared_ptr<const SensorSpec> spec,
                                        const SensedAgent& agent, std::uint64_t key);
std::unique_ptr<RigSensor> MakeRigCamera(std::shared_ptr<const SensorSpec> spec,
                                         const SensedAgent& agent, std::uint64_t key);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_RIG_SENSOR_H_
