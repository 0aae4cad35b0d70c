#ifndef LATTICEWORLD_SENSING_RAY_SCENE_H_
#define LATTICEWORLD_SENSING_RAY_SCENE_H_

#include <Eigen/Core>
#include <memory>

#include "latticeworld/common/result.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace latticeworld {

class HeightField;

// The ground as ray sensors meet it: the one triangulation of HeightField, with the same diagonals,
// out to the world's edge, in Embree (Wald et al. 2014). Rays may be shot from several threads.
class RayScene {
 public:
  // Copies the heights. Errors: RESOURCE_EXHAUSTED (no memory), INTERNAL (Embree, in its words).
  static Result<RayScene> Create(const HeightField& ground);
  RayScene(RayScene&&) noexcept = default;
  RayScene& operator=(RayScene&&) noexcept = default;

  // How far a ray from origin_m along direction (unit), both in the frame map, goes until it meets
  // the ground, from above or below [m]; infinity where it does not.
  double Distance(const Eigen::Vector3d& origin_m, const Eigen::Vector3d& direction) const;

 private:
  RayScene() = default;

  struct Release {
    void operator()(RTCDeviceTy* device) const;
    void operator()(RTCSceneTy* scene) const;
  };
  std::unique_ptr<RTCDeviceTy, Release> device_;
  std::unique_ptr<RTCSceneTy, Release> scene_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_RAY_SCENE_H_
