#ifndef LATTICEWORLD_SENSING_SOLIDS_MESH_FRAME_H_
#define LATTICEWORLD_SENSING_SOLIDS_MESH_FRAME_H_

#include <embree3/rtcore.h>

#include <Eigen/Core>

namespace latticeworld {

// What carries rays from the map into the frame of a mesh. Directions do not stay unit, so that
// distances stay those of the map.
struct MeshFrame {
  Eigen::Matrix3f mesh_from_map = Eigen::Matrix3f::Identity();  // of directions
  Eigen::Vector3f origin_m = Eigen::Vector3f::Zero();           // of the mesh's frame, in the map
};

// Serves callbacks of user geometries, whose rays come one by one or as many at once as the
// processor takes (4, 8 or 16): they meet a mesh, if one of the bits of `mask` is theirs. Hits have
// 1 and the number of the user primitive in geomID, that of the triangle in primID, the normal in
// the map frame, and in instID what the context has.
void IntersectMesh(RTCScene mesh, const MeshFrame& frame, unsigned mask,
                   const RTCIntersectFunctionNArguments& arguments);
// One by one only.
void OccludeByMesh(RTCScene mesh, const MeshFrame& frame, unsigned mask,
                   const RTCOccludedFunctionNArguments& arguments);

// Returns the box in the map that holds the scene of a mesh.
RTCBounds BoundsInMap(RTCScene mesh, const Eigen::Matrix<float, 3, 4>& map_from_mesh);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SOLIDS_MESH_FRAME_H_
