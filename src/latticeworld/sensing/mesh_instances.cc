#include "latticeworld/sensing/mesh_instances.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace latticeworld {
namespace {

// Hardly anything leans.
bool Leans(const MeshInstance& instance) { return instance.sin_lean != 0.0f; }

Eigen::Vector3f Turned(const MeshInstance& instance, float x, float y, float z) {
  if (Leans(instance)) {
    const float upright_x = x;
    x = instance.cos_lean * upright_x + instance.sin_lean * z;
    z = instance.cos_lean * z - instance.sin_lean * upright_x;
  }
  return {instance.cos_yaw * x - instance.sin_yaw * y, instance.sin_yaw * x + instance.cos_yaw * y,
          z};
}

Eigen::Vector3f TurnedBack(const MeshInstance& instance, float x, float y, float z) {
  const float c = instance.cos_yaw, s = instance.sin_yaw;
  Eigen::Vector3f back(c * x + s * y, c * y - s * x, z);
  if (Leans(instance)) {
    const float leaning_x = back.x();
    back.x() = instance.cos_lean * leaning_x - instance.sin_lean * z;
    back.z() = instance.cos_lean * z + instance.sin_lean * leaning_x;
  }
  return back;
}

RTCRay IntoFrameOf(const MeshInstance& instance, const RTCRay& ray) {
  const Eigen::Vector3f inverse = instance.size_m.cwiseInverse();
  const Eigen::Vector3f origin =
      TurnedBack(instance, ray.org_x - instance.position_m.x(), ray.org_y - instance.position_m.y(),
                 ray.org_z - instance.position_m.z());
  // Not a unit vector, so that distances stay those of the world.
  const Eigen::Vector3f direction = TurnedBack(instance, ray.dir_x, ray.dir_y, ray.dir_z);
  RTCRay local = ray;
  local.org_x = origin.x() * inverse.x();
  local.org_y = origin.y() * inverse.y();
  local.org_z = origin.z() * inverse.z();
  local.dir_x = direction.x() * inverse.x();
  local.dir_y = direction.y() * inverse.y();
  local.dir_z = direction.z() * inverse.z();
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
  const Eigen::Vector3f center =
      instance.position_m + Turned(instance, middle.x(), middle.y(), middle.z());
  const float c = std::abs(instance.cos_yaw), s = std::abs(instance.sin_yaw);
  const float cl = std::abs(instance.cos_lean), sl = std::abs(instance.sin_lean);
  const float along_m = Leans(instance) ? cl * reach.x() + sl * reach.z() : reach.x();
  const float dz_m = Leans(instance) ? sl * reach.x() + cl * reach.z() : reach.z();
  const float dx_m = c * along_m + s * reach.y(), dy_m = s * along_m + c * reach.y();
  *arguments->bounds_o = {center.x() - dx_m, center.y() - dy_m, center.z() - dz_m, 0.0f,
                          center.x() + dx_m, center.y() + dy_m, center.z() + dz_m, 0.0f};
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
  const Eigen::Vector3f normal =
      Turned(instance, local.hit.Ng_x / instance.size_m.x(), local.hit.Ng_y / instance.size_m.y(),
             local.hit.Ng_z / instance.size_m.z());
  world.hit.Ng_x = normal.x();
  world.hit.Ng_y = normal.y();
  world.hit.Ng_z = normal.z();
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
