#include "latticeworld/sensing/solids/mesh_instances.h"

#include <algorithm>
#include <utility>

#include "latticeworld/sensing/solids/mesh_frame.h"

namespace latticeworld {
namespace {

// Columns: the axes of the mesh's frame in the map, unit.
Eigen::Matrix3f AxesOf(const MeshInstance& instance) {
  const float c = instance.cos_yaw, s = instance.sin_yaw;
  const float cl = instance.cos_lean, sl = instance.sin_lean;
  const float ct = instance.cos_twist, st = instance.sin_twist;
  Eigen::Matrix3f axes;
  axes << c * cl * ct - s * st, -c * cl * st - s * ct, c * sl,  //
      s * cl * ct + c * st, c * ct - s * cl * st, s * sl,       //
      -sl * ct, sl * st, cl;
  return axes;
}

MeshFrame FrameOf(const MeshInstance& instance) {
  return {instance.size_m.cwiseInverse().asDiagonal() * AxesOf(instance).transpose(),
          instance.position_m};
}

}  // namespace

Eigen::Matrix<float, 3, 4> MapFromMesh(const MeshInstance& instance) {
  Eigen::Matrix<float, 3, 4> map_from_mesh;
  map_from_mesh << AxesOf(instance) * instance.size_m.asDiagonal(), instance.position_m;
  return map_from_mesh;
}

Result<MeshPrototype> MakePrototype(RTCDevice device, const std::vector<Eigen::Vector3f>& vertices,
                                    const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                    std::vector<std::uint8_t> parts) {
  MeshPrototype prototype;
  prototype.parts = std::move(parts);
  prototype.vertices = vertices.size();
  prototype.scene.reset(rtcNewScene(device));
  // Without this flag, rays that meet an edge or a corner may slip through.
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
  *arguments->bounds_o = BoundsInMap(self.SceneOf(instance), MapFromMesh(instance));
}

void MeshInstances::Intersect(const RTCIntersectFunctionNArguments* arguments) {
  const auto& self = *static_cast<const MeshInstances*>(arguments->geometryUserPtr);
  const MeshInstance& instance = self.instances_[arguments->primID];
  IntersectMesh(self.SceneOf(instance), FrameOf(instance), ~0u, *arguments);
}

void MeshInstances::Occlude(const RTCOccludedFunctionNArguments* arguments) {
  const auto& self = *static_cast<const MeshInstances*>(arguments->geometryUserPtr);
  const MeshInstance& instance = self.instances_[arguments->primID];
  OccludeByMesh(self.SceneOf(instance), FrameOf(instance), ~0u, *arguments);
}

}  // namespace latticeworld
