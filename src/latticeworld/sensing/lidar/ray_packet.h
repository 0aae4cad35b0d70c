#ifndef LATTICEWORLD_SENSING_LIDAR_RAY_PACKET_H_
#define LATTICEWORLD_SENSING_LIDAR_RAY_PACKET_H_

#include <embree3/rtcore.h>

#include <cmath>

#include "latticeworld/sensing/solids/ray_scene.h"

namespace latticeworld {

// Traces up to 16 rays together, through one scene after the other. Each scene brings nearer the
// ends of the rays that meet it; `met` and rays.hit are of the last one.
struct RayPacket {
  static constexpr int kSize = 16;

  // count: [1, kSize]. mask: sights that the rays have. Rays that are not legal are left out.
  void Load(const Ray* rays, int count, unsigned mask);
  // Traces on in one more scene.
  void Trace(RTCScene scene, RTCIntersectContext* context);
  bool met(int lane) const { return rays.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID; }
  Eigen::Vector3f normal(int lane) const {
    return {rays.hit.Ng_x[lane], rays.hit.Ng_y[lane], rays.hit.Ng_z[lane]};
  }

  alignas(64) int valid[kSize];    // -1: there is a ray, 0: there is none
  alignas(64) int met_any[kSize];  // 1: some scene was met, at rays.ray.tfar
  alignas(64) RTCRayHit16 rays;
};

// Returns a context for rays that run side by side.
RTCIntersectContext CoherentContext();

// Whether Embree may be given the ray: its numbers are numbers, and not beyond all measure. Others
// meet nothing.
inline bool IsLegal(const Ray& ray) {
  // Embree takes up to 1.8e18, and small meshes have rays scaled up in their frames.
  constexpr float kFarthest = 1e9f;
  bool is_number = true;
  for (const Eigen::Vector3f* of : {&ray.origin_m, &ray.direction}) {
    for (const float value : {of->x(), of->y(), of->z()}) is_number &= std::abs(value) <= kFarthest;
  }
  return is_number && ray.from_m <= ray.to_m && ray.to_m >= 0.0f;
}

// Converts a legal ray (IsLegal) into Embree's form.
RTCRay ToEmbree(const Ray& ray, unsigned mask = ~0u);

// Whether the ray meets anything in the scene.
bool IsOccluded(RTCScene scene, RTCIntersectContext* context, RTCRay ray);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_LIDAR_RAY_PACKET_H_
