#ifndef LATTICEWORLD_SENSING_SENSOR_RIG_H_
#define LATTICEWORLD_SENSING_SENSOR_RIG_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/sensing/sensed_world.h"
#include "latticeworld/sensing/sensor_suite.h"

namespace latticeworld {

struct Scene;

// What one sensor gave at one moment; the alternative of `reading` is that of the spec's model.
struct SensorFrame {
  std::string robot;
  std::shared_ptr<const SensorSpec> sensor;  // never null
  double time_s = 0.0;  // when it was complete: a sweep's end; the stamp of its messages
  std::variant<LidarSweep, CameraFrame, ImuReading, GnssReading, MagnetometerReading,
               WheelOdometryReading, BumperReading>
      reading;
};

// Draws what colour cameras see; the colours of things belong to a higher room.
class ColourRenderer {
 public:
  virtual ~ColourRenderer() = default;
  // Fills frame->colour, without the camera's noise; map_from_optical: where the camera is. world:
  // as the scene was updated with.
  virtual void Render(const class SensorScene& scene, const SensedWorld& world,
                      const CameraModel& model, const Eigen::Isometry3d& map_from_optical,
                      std::uint32_t except_agent, CameraFrame* frame) const = 0;
};

struct SensorRigOptions {
  std::uint64_t seed = 0;  // of all noise
  GeoOrigin origin;
  double gravity_mps2 = 9.81;  // of the simulated world, along -z; what an IMU at rest reads
  // That trace rays, of several robots at once where there are some; 0: as many as the machine has
  // cores. Readings are the same with any.
  int threads = 1;
  std::shared_ptr<const ColourRenderer> colours;  // null: colour pictures stay empty
};

// What somebody wants of a sensor now.
struct SensorWish {
  bool any = false;
  CameraOutputs pictures;  // of a camera: those that are wanted; what it does not offer is not made
};

// The sensors of every agent of a world that has some. Told of every step in turn, it gives what
// becomes complete with it. A lidar's column is fired at its own time, from where the sensor,
// moving evenly between two steps, then is, at what stands where the step at or after that time
// left it. Same steps, wishes and seed: the same readings. One thread owns it.
class SensorRig {
 public:
  // What anybody wants of a robot's sensor now. Lidars begin with the next whole revolution; noise
  // is a function of the seed, the robot, the sensor and the reading's number since step 0, so that
  // readings do not depend on who listened before.
  using Wanted = std::function<SensorWish(const std::string& robot, const SensorSpec& sensor)>;

  // suite_of: the suite of a robot when it first appears; null: none.
  static Result<std::unique_ptr<SensorRig>> Create(
      std::shared_ptr<const Scene> scene, const SensorRigOptions& options,
      std::function<std::shared_ptr<const SensorSuite>(const SensedAgent&)> suite_of);
  virtual ~SensorRig() = default;

  // world.step: one above the last call's, or anything after Restart; elsewhere it is as after a
  // Restart with the same seed. Frames are sorted by robot and sensor. The rays' scene is made when
  // the first ray is wanted (0.4 s and 130 MiB for 1 km with 100,000 trees). Errors are Embree's.
  virtual Result<std::vector<SensorFrame>> Step(const SensedWorld& world, double step_s,
                                                const Wanted& wanted) = 0;
  // Is to be called after a reset, a restore or a gap: the next Step is a beginning, from which
  // odometry counts and IMUs and lidars begin with the next whole interval; seed: of noise from
  // then on.
  virtual void Restart(std::uint64_t seed) = 0;
  // Whether the step after `step` matters to what is wanted: something is due then, or a lidar, an
  // IMU, wheel odometry or a bumper is collecting. Robots count that the last Step met; before the
  // first one, and after Restart, it is true.
  virtual bool NeedsStep(std::uint64_t step, double step_s, const Wanted& wanted) const = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SENSOR_RIG_H_
