#ifndef LATTICEWORLD_SENSING_RIG_WORLD_H_
#define LATTICEWORLD_SENSING_RIG_WORLD_H_

#include <Eigen/Core>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/sensing/lidar/lidar_surfaces.h"
#include "latticeworld/sensing/sensor_rig.h"
#include "latticeworld/sensing/sensor_scene.h"

namespace latticeworld {

// What the sensors of all robots share: the world of the step, and the rays' scene, which is made
// when somebody wants the first ray and follows the world in steps in which somebody wants one. All
// but BeginStep may be called by several threads at a time.
class RigWorld {
 public:
  RigWorld(std::shared_ptr<const Scene> scene, SensorRigOptions options)
      : scene_(std::move(scene)), options_(std::move(options)) {}

  // eyes_m: where the sensors are that trace rays, listened to or not, so that what is near them
  // has its detail whoever listens. world lives until the next BeginStep.
  void BeginStep(const SensedWorld& world, std::vector<Eigen::Vector3d> eyes_m);

  // Returns the scene as the world of this step is. Errors are Embree's.
  Result<const SensorScene*> Rays();
  // Returns the surfaces under the weather of this step.
  const LidarSurfaces& surfaces();

  const SensedWorld& world() const { return *world_; }
  const Scene& scene() const { return *scene_; }
  const SensorRigOptions& options() const { return options_; }

 private:
  std::shared_ptr<const Scene> scene_;
  SensorRigOptions options_;
  const SensedWorld* world_ = nullptr;
  std::vector<Eigen::Vector3d> eyes_m_;
  std::mutex mutex_;  // for what is made when it is first asked for
  bool rays_are_of_step_ = false, surfaces_are_of_step_ = false;
  std::optional<SensorScene> rays_;
  std::optional<LidarSurfaces> surfaces_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_RIG_WORLD_H_
