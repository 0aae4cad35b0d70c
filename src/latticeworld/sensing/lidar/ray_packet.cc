#include "latticeworld/sensing/lidar/ray_packet.h"

#include <algorithm>

namespace latticeworld {

void RayPacket::Load(const Ray* list, int count, unsigned mask) {
  RTCRay16& ray = rays.ray;
  for (int lane = 0; lane < kSize; ++lane) {
    const bool is_ray = lane < count && IsLegal(list[lane]);
    const Ray one = is_ray ? list[lane] : Ray();
    valid[lane] = is_ray ? -1 : 0;
    met_any[lane] = 0;
    ray.org_x[lane] = one.origin_m.x();
    ray.org_y[lane] = one.origin_m.y();
    ray.org_z[lane] = one.origin_m.z();
    ray.tnear[lane] = std::max(0.0f, one.from_m);
    ray.dir_x[lane] = one.direction.x();
    ray.dir_y[lane] = one.direction.y();
    ray.dir_z[lane] = one.direction.z();
    ray.time[lane] = 0.0f;
    ray.tfar[lane] = one.to_m;
    ray.mask[lane] = mask;
    ray.id[lane] = static_cast<unsigned>(lane);
    ray.flags[lane] = 0;
  }
}

void RayPacket::Trace(RTCScene scene, RTCIntersectContext* context) {
  for (unsigned& geometry : rays.hit.geomID) geometry = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect16(valid, scene, context, &rays);
  for (int lane = 0; lane < kSize; ++lane) met_any[lane] |= met(lane) ? 1 : 0;
}

RTCIntersectContext CoherentContext() {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}

RTCRay ToEmbree(const Ray& ray, unsigned mask) {
  RTCRay result = {};
  result.org_x = ray.origin_m.x();
  result.org_y = ray.origin_m.y();
  result.org_z = ray.origin_m.z();
  result.dir_x = ray.direction.x();
  result.dir_y = ray.direction.y();
  result.dir_z = ray.direction.z();
  result.tnear = std::max(0.0f, ray.from_m);
  result.tfar = ray.to_m;
  result.mask = mask;
  return result;
}

bool IsOccluded(RTCScene scene, RTCIntersectContext* context, RTCRay ray) {
  rtcOccluded1(scene, context, &ray);
  return ray.tfar < 0.0f;
}

}  // namespace latticeworld
