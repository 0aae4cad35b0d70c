#ifndef LATTICEWORLD_EXPORTING_GLTF_MODEL_MESH_H_
#define LATTICEWORLD_EXPORTING_GLTF_MODEL_MESH_H_

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "latticeworld/exporting/gltf/glb_document.h"
#include "latticeworld/meshes/mesh.h"

namespace latticeworld {

struct Asset;
struct Scene;

// Colours of the parts of a model [linear RGB].
using ModelColors = std::array<Eigen::Vector3f, kMeshPartCount>;

// Names of the parts in materials: "leaves", "bark", "blossom", "stone", "wall", "roof", "window",
// "door", "trim".
const char* NameOf(MeshPart part);

// What decides the colour of most of a thing.
MeshPart MainPartOf(AssetKind kind);

// Mean colours of the parts of those assets (numbers in scene.assets, at least one), as the
// pictures have them in the scene's season, weather and style: what faces up is white by half of
// the snow on it.
ModelColors MeanColors(const Scene& scene, const std::vector<std::uint32_t>& assets);

// A mesh's triangles by part, of vertices that they share.
struct ModelGeometry {
  int positions = -1;                       // accessors
  std::array<int, kMeshPartCount> indices;  // -1: the mesh has no such part
};
// Vertices at one place become one: triangles are flat. quantized: in steps of 1 / 32767 where the
// mesh keeps within [-1, 1].
ModelGeometry AddGeometry(const Mesh& mesh, bool quantized, GlbDocument* document);

// Materials "<name>/<part>" of the parts that the geometry has, in the order of MeshPart.
std::array<int, kMeshPartCount> AddMaterials(const std::string& name, const ModelColors& colors,
                                             const ModelGeometry& geometry, GlbDocument* document);

// The mesh "<name>" of the two.
int AddModel(const std::string& name, const ModelGeometry& geometry,
             const std::array<int, kMeshPartCount>& materials, GlbDocument* document);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_GLTF_MODEL_MESH_H_
