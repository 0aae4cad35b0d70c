#include "latticeworld/sensing/solids/mesh_frame.h"

#include <algorithm>
#include <iterator>

namespace latticeworld {
namespace {

RTCRay IntoFrame(const MeshFrame& frame, const RTCRay& ray) {
  const Eigen::Vector3f origin =
      frame.mesh_from_map * (Eigen::Vector3f(ray.org_x, ray.org_y, ray.org_z) - frame.origin_m);
  const Eigen::Vector3f direction =
      frame.mesh_from_map * Eigen::Vector3f(ray.dir_x, ray.dir_y, ray.dir_z);
  RTCRay local = ray;
  local.org_x = origin.x();
  local.org_y = origin.y();
  local.org_z = origin.z();
  local.dir_x = direction.x();
  local.dir_y = direction.y();
  local.dir_z = direction.z();
  return local;
}

// Transforms all lanes into the mesh's frame, whether they have a ray or not. RayN: RTCRay4,
// RTCRay8 or RTCRay16.
template <int kLanes, typename RayN>
void IntoFrame(const MeshFrame& frame, const RayN& ray, RayN* local) {
  const Eigen::Matrix3f& t = frame.mesh_from_map;
  const Eigen::Vector3f& at = frame.origin_m;
  for (int i = 0; i < kLanes; ++i) {
    const float x = ray.org_x[i] - at.x(), y = ray.org_y[i] - at.y(), z = ray.org_z[i] - at.z();
    local->org_x[i] = t(0, 0) * x + t(0, 1) * y + t(0, 2) * z;
    local->org_y[i] = t(1, 0) * x + t(1, 1) * y + t(1, 2) * z;
    local->org_z[i] = t(2, 0) * x + t(2, 1) * y + t(2, 2) * z;
  }
  for (int i = 0; i < kLanes; ++i) {
    const float x = ray.dir_x[i], y = ray.dir_y[i], z = ray.dir_z[i];
    local->dir_x[i] = t(0, 0) * x + t(0, 1) * y + t(0, 2) * z;
    local->dir_y[i] = t(1, 0) * x + t(1, 1) * y + t(1, 2) * z;
    local->dir_z[i] = t(2, 0) * x + t(2, 1) * y + t(2, 2) * z;
  }
  for (int i = 0; i < kLanes; ++i) {
    local->tnear[i] = ray.tnear[i];
    local->tfar[i] = ray.tfar[i];
    local->time[i] = 0.0f;
    local->mask[i] = ray.mask[i];
    local->id[i] = ray.id[i];
    local->flags[i] = 0;
  }
}

void TraceInMesh(const int* valid, RTCScene mesh, RTCIntersectContext* context, RTCRayHit4* rays) {
  rtcIntersect4(valid, mesh, context, rays);
}
void TraceInMesh(const int* valid, RTCScene mesh, RTCIntersectContext* context, RTCRayHit8* rays) {
  rtcIntersect8(valid, mesh, context, rays);
}
void TraceInMesh(const int* valid, RTCScene mesh, RTCIntersectContext* context, RTCRayHit16* rays) {
  rtcIntersect16(valid, mesh, context, rays);
}

void IntersectOne(RTCScene mesh, const MeshFrame& frame, unsigned mask,
                  const RTCIntersectFunctionNArguments& arguments) {
  auto& world = *reinterpret_cast<RTCRayHit*>(arguments.rayhit);
  if (arguments.valid[0] == 0 || (world.ray.mask & mask) == 0) return;
  RTCRayHit local;
  local.ray = IntoFrame(frame, world.ray);
  local.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(mesh, arguments.context, &local);
  if (local.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
  world.ray.tfar = local.ray.tfar;
  // Normals go by the inverse transposed.
  const Eigen::Vector3f normal = frame.mesh_from_map.transpose() *
                                 Eigen::Vector3f(local.hit.Ng_x, local.hit.Ng_y, local.hit.Ng_z);
  world.hit.Ng_x = normal.x();
  world.hit.Ng_y = normal.y();
  world.hit.Ng_z = normal.z();
  world.hit.u = local.hit.u;
  world.hit.v = local.hit.v;
  world.hit.geomID = 1 + arguments.primID;
  world.hit.primID = local.hit.primID;
  world.hit.instID[0] = arguments.context->instID[0];
}

template <int kLanes, typename RayHitN>
void IntersectSeveral(RTCScene mesh, const MeshFrame& frame, unsigned mask,
                      const RTCIntersectFunctionNArguments& arguments) {
  auto& world = *reinterpret_cast<RayHitN*>(arguments.rayhit);
  alignas(64) int valid[kLanes];
  for (int i = 0; i < kLanes; ++i)
    valid[i] = (world.ray.mask[i] & mask) != 0 ? arguments.valid[i] : 0;
  alignas(64) RayHitN local;
  IntoFrame<kLanes>(frame, world.ray, &local.ray);
  std::fill(std::begin(local.hit.geomID), std::end(local.hit.geomID), RTC_INVALID_GEOMETRY_ID);
  TraceInMesh(valid, mesh, arguments.context, &local);
  for (int i = 0; i < kLanes; ++i) {
    if (valid[i] == 0 || local.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    world.ray.tfar[i] = local.ray.tfar[i];
    const Eigen::Vector3f normal =
        frame.mesh_from_map.transpose() *
        Eigen::Vector3f(local.hit.Ng_x[i], local.hit.Ng_y[i], local.hit.Ng_z[i]);
    world.hit.Ng_x[i] = normal.x();
    world.hit.Ng_y[i] = normal.y();
    world.hit.Ng_z[i] = normal.z();
    world.hit.u[i] = local.hit.u[i];
    world.hit.v[i] = local.hit.v[i];
    world.hit.geomID[i] = 1 + arguments.primID;
    world.hit.primID[i] = local.hit.primID[i];
    world.hit.instID[0][i] = arguments.context->instID[0];
  }
}

}  // namespace

void IntersectMesh(RTCScene mesh, const MeshFrame& frame, unsigned mask,
                   const RTCIntersectFunctionNArguments& arguments) {
  switch (arguments.N) {
    case 1:
      return IntersectOne(mesh, frame, mask, arguments);
    case 4:
      return IntersectSeveral<4, RTCRayHit4>(mesh, frame, mask, arguments);
    case 8:
      return IntersectSeveral<8, RTCRayHit8>(mesh, frame, mask, arguments);
    case 16:
      return IntersectSeveral<16, RTCRayHit16>(mesh, frame, mask, arguments);
    default:
      return;  // Embree has no other packets
  }
}

void OccludeByMesh(RTCScene mesh, const MeshFrame& frame, unsigned mask,
                   const RTCOccludedFunctionNArguments& arguments) {
  if (arguments.N != 1 || arguments.valid[0] == 0) return;
  auto& world = *reinterpret_cast<RTCRay*>(arguments.ray);
  if ((world.mask & mask) == 0) return;
  RTCRay local = IntoFrame(frame, world);
  rtcOccluded1(mesh, arguments.context, &local);
  if (local.tfar < 0.0f) world.tfar = local.tfar;  // minus infinity: met
}

RTCBounds BoundsInMap(RTCScene mesh, const Eigen::Matrix<float, 3, 4>& map_from_mesh) {
  RTCBounds own;
  rtcGetSceneBounds(mesh, &own);
  const Eigen::Vector3f low(own.lower_x, own.lower_y, own.lower_z);
  const Eigen::Vector3f high(own.upper_x, own.upper_y, own.upper_z);
  const Eigen::Matrix3f linear = map_from_mesh.leftCols<3>();
  const Eigen::Vector3f middle = linear * (0.5f * (low + high)) + map_from_mesh.col(3);
  const Eigen::Vector3f reach = linear.cwiseAbs() * (0.5f * (high - low));
  const Eigen::Vector3f lowest = middle - reach, highest = middle + reach;
  return {lowest.x(), lowest.y(), lowest.z(), 0.0f, highest.x(), highest.y(), highest.z(), 0.0f};
}

}  // namespace latticeworld
