#ifndef LATTICEWORLD_BENCHMARKS_SENSING_RAYS_H_
#define LATTICEWORLD_BENCHMARKS_SENSING_RAYS_H_

#include <embree3/rtcore.h>

#include <Eigen/Core>
#include <vector>

#include "latticeworld/scene/scene.h"
#include "latticeworld/sensing/solids/ray_scene.h"

namespace latticeworld {

// Rays in blocks of 4 x 4 side by side, out of one place. A revolution of 64 rings from -16.6 to
// 16.6 degrees and 1024 columns, up to 120 m; a picture of 640 x 480 pixels, 90 degrees wide, up to
// 100 m.
std::vector<Ray> LidarRays(const Eigen::Vector3f& eye_m);
std::vector<Ray> DepthRays(const Eigen::Vector3f& eye_m);

// The same as Embree takes them, 16 at once.
std::vector<RTCRayHit16> PacketsOf(const std::vector<Ray>& rays);

// How far a ray goes as a user would write it: in steps of half a cell over the height field
// (bilinear between its cells), and past every tree of a list of those near the eye, a trunk that
// is a cylinder and a crown that is an ellipsoid [m]; infinity: nothing.
class RayMarch {
 public:
  RayMarch(const Scene& scene, const Eigen::Vector3f& eye_m, float range_m);
  float Distance(const Ray& ray) const;

 private:
  const Scene& scene_;
  std::vector<const Asset*> near_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_BENCHMARKS_SENSING_RAYS_H_
