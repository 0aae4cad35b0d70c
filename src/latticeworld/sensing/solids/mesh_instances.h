#ifndef LATTICEWORLD_SENSING_SOLIDS_MESH_INSTANCES_H_
#define LATTICEWORLD_SENSING_SOLIDS_MESH_INSTANCES_H_

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/sensing/solids/embree_handles.h"

namespace latticeworld {

// A mesh that is kept once and met in many places.
struct MeshPrototype {
  EmbreeScene scene;                // of one geometry, number 0; empty where it has no triangles
  std::vector<std::uint8_t> parts;  // one a triangle; empty: all 0
  std::size_t vertices = 0;
};

// Errors are the device's: Embree keeps them for each thread, so they are asked for here.
Result<MeshPrototype> MakePrototype(RTCDevice device, const std::vector<Eigen::Vector3f>& vertices,
                                    const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                    std::vector<std::uint8_t> parts);

// Says where a mesh is met: it is multiplied by size_m, twisted about z, leaned from z towards x,
// turned by a yaw about z, moved to position_m.
struct MeshInstance {
  Eigen::Vector3f position_m;
  Eigen::Vector3f size_m;  // > 0
  float cos_yaw = 1.0f;
  float sin_yaw = 0.0f;
  float cos_lean = 1.0f;
  float sin_lean = 0.0f;
  float cos_twist = 1.0f;
  float sin_twist = 0.0f;
  std::uint32_t index = 0;      // in its owner's list
  std::uint16_t prototype = 0;  // in the list that the instances share
};
// Returns the transform from the mesh's frame; columns x, y, z, origin.
Eigen::Matrix<float, 3, 4> MapFromMesh(const MeshInstance& instance);

// Embree's own instances take about a kilobyte each; here all of them are the primitives of one
// user geometry, whose callbacks carry rays into the mesh's frame. Hits are as of IntersectMesh
// (mesh_frame.h). Must stay where it is while a scene holds the geometry.
class MeshInstances {
 public:
  using Prototypes = std::vector<std::shared_ptr<const MeshPrototype>>;  // none null

  MeshInstances(Prototypes prototypes, std::vector<MeshInstance> instances)
      : prototypes_(std::move(prototypes)), instances_(std::move(instances)) {}
  MeshInstances(const MeshInstances&) = delete;
  MeshInstances& operator=(const MeshInstances&) = delete;

  bool empty() const { return instances_.empty(); }
  // Makes an Embree geometry of all instances; an empty geometry if there is none.
  EmbreeGeometry MakeGeometry(RTCDevice device) const;

  // These tell the instance and the part that a hit is of.
  const MeshInstance& InstanceOf(unsigned geometry) const { return instances_[geometry - 1]; }
  std::uint8_t PartOf(unsigned geometry, unsigned triangle) const {
    return prototypes_[InstanceOf(geometry).prototype]->parts[triangle];
  }

 private:
  RTCScene SceneOf(const MeshInstance& instance) const {
    return prototypes_[instance.prototype]->scene.get();
  }
  static void Bound(const RTCBoundsFunctionArguments* arguments);
  static void Intersect(const RTCIntersectFunctionNArguments* arguments);
  static void Occlude(const RTCOccludedFunctionNArguments* arguments);

  Prototypes prototypes_;
  std::vector<MeshInstance> instances_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SOLIDS_MESH_INSTANCES_H_
