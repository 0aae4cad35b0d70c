#include "latticeworld/sensing/mesh_instances.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace latticeworld {
namespace {

RTCRay IntoFrameOf(const MeshInstance& instance, const RTCRay& ray) {
  const float c = instance.cos_yaw, s = instance.sin_yaw;
  const Eigen::Vector3f inverse = instance.size_m.cwiseInverse();
  const float x = ray.org_x - instance.position_m.x(), y = ray.org_y - instance.position_m.y();
  RTCRay local = ray;
  local.org_x = (c * x + s * y) * inverse.x();
  local.org_y = (c * y - s * x) * inverse.y();
  local.org_z = (ray.org_z - instance.position_m.z()) * inverse.z();
  // Not a unit vector, so that distances stay those of the world.
  local.dir_x = (c * ray.dir_x + s * ray.dir_y) * inverse.x();
  local.dir_y = (c * ray.dir_y - s * ray.dir_x) * inverse.y();
  local.dir_z = ray.dir_z * inverse.z();
  return local;
}

}  // namespace

Result<MeshPrototype> MakePrototype(RTCDevice device, const std::vector<Eigen::Vector3f>& vertices,
                                    const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                    std::vector<std::uint8_t> parts) {
  MeshPrototype prototype;
  prototype.parts = std::move(parts);
  prototype.scene.reset(rtcNewScene(device));
  // Else rays that meet an edge or a corner may slip through.
  rtcSetSceneFlags(prototype.scene.get(), RTC_SCENE_FLAG_ROBUST);
  if (!triangles.empty()) {
    const EmbreeGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
    auto* points = static_cast<Eigen::Vector3f*>(
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(Eigen::Vector3f), vertices.size()));
    auto* corners = static_cast<std::array<std::uint32_t, 3>*>(
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                sizeof(std::array<std::uint32_t, 3>), triangles.size()));
    if (points != nullptr && corners != nullptr) {
      std::copy(vertices.begin(), vertices.end(), points);
      std::copy(triangles.begin(), triangles.end(), corners);
      rtcCommitGeometry(geometry.get());
      rtcAttachGeometry(prototype.scene.get(), geometry.get());
    }
  }
  rtcCommitScene(prototype.scene.get());
  LW_RETURN_IF_ERROR(EmbreeStatus(device));
  return prototype;
}

EmbreeGeometry MeshInstances::MakeGeometry(RTCDevice device) const {
  EmbreeGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER));
  rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(instances_.size()));
  rtcSetGeometryUserData(geometry.get(), const_cast<MeshInstances*>(this));
  rtcSetGeometryBoundsFunction(geometry.get(), Bound, nullptr);
  rtcSetGeometryIntersectFunction(geometry.get(), Intersect);
  rtcSetGeometryOccludedFunction(geometry.get(), Occlude);
  rtcCommitGeometry(geometry.get());
  return geometry;
}

void MeshInstances::Bound(const RTCBoundsFunctionArguments* arguments) {
  const auto& self = *static_cast<const MeshInstances*>(arguments->geometryUserPtr);
  const MeshInstance& instance = self.instances_[arguments->primID];
  RTCBounds mesh;
  rtcGetSceneBounds(self.prototypes_[instance.prototype].scene.get(), &mesh);
  const Eigen::Array3f size = instance.size_m.array();
  const Eigen::Array3f low = Eigen::Array3f(mesh.lower_x, mesh.lower_y, mesh.lower_z) * size;
  const Eigen::Array3f high = Eigen::Array3f(mesh.upper_x, mesh.upper_y, mesh.upper_z) * size;
  const Eigen::Array3f middle = 0.5f * (low + high), reach = 0.5f * (high - low);
  const float c = instance.cos_yaw, s = instance.sin_yaw;
  const float x_m = instance.position_m.x() + c * middle.x() - s * middle.y();
  const float y_m = instance.position_m.y() + s * middle.x() + c * middle.y();
  const float z_m = instance.position_m.z() + middle.z();
  const float dx_m = std::abs(c) * reach.x() + std::abs(s) * reach.y();
  const float dy_m = std::abs(s) * reach.x() + std::abs(c) * reach.y();
  *arguments->bounds_o = {x_m - dx_m, y_m - dy_m, z_m - reach.z(), 0.0f,
                          x_m + dx_m, y_m + dy_m, z_m + reach.z(), 0.0f};
}

void MeshInstances::Intersect(const RTCIntersectFunctionNArguments* arguments) {
  if (arguments->N != 1 || arguments->valid[0] == 0) return;  // rays come one by one
  const auto& self = *static_cast<const MeshInstances*>(arguments->geometryUserPtr);
  const MeshInstance& instance = self.instances_[arguments->primID];
  auto& world = *reinterpret_cast<RTCRayHit*>(arguments->rayhit);
  RTCRayHit local;
  local.ray = IntoFrameOf(instance, world.ray);
  local.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(self.prototypes_[instance.prototype].scene.get(), arguments->context, &local);
  if (local.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
  world.ray.tfar = local.ray.tfar;
  // Normals go by the inverse transposed.
  const float x = local.hit.Ng_x / instance.size_m.x(), y = local.hit.Ng_y / instance.size_m.y();
  world.hit.Ng_x = instance.cos_yaw * x - instance.sin_yaw * y;
  world.hit.Ng_y = instance.sin_yaw * x + instance.cos_yaw * y;
  world.hit.Ng_z = local.hit.Ng_z / instance.size_m.z();
  world.hit.u = local.hit.u;
  world.hit.v = local.hit.v;
  world.hit.geomID = arguments->geomID;
  world.hit.primID = local.hit.primID;
  world.hit.instID[0] = arguments->primID;
}

void MeshInstances::Occlude(const RTCOccludedFunctionNArguments* arguments) {
  if (arguments->N != 1 || arguments->valid[0] == 0) return;
  const auto& self = *static_cast<const MeshInstances*>(arguments->geometryUserPtr);
  const MeshInstance& instance = self.instances_[arguments->primID];
  auto& world = *reinterpret_cast<RTCRay*>(arguments->ray);
  RTCRay local = IntoFrameOf(instance, world);
  rtcOccluded1(self.prototypes_[instance.prototype].scene.get(), arguments->context, &local);
  if (local.tfar < 0.0f) world.tfar = local.tfar;  // minus infinity: met
}

}  // namespace latticeworld
