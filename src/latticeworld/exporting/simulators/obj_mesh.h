#ifndef LATTICEWORLD_EXPORTING_SIMULATORS_OBJ_MESH_H_
#define LATTICEWORLD_EXPORTING_SIMULATORS_OBJ_MESH_H_

#include <string>

#include "latticeworld/exporting/gltf/model_mesh.h"
#include "latticeworld/meshes/mesh.h"

namespace latticeworld {

struct SurfaceMesh;

// Wavefront OBJ text of a mesh, z up as it is, flat, a material a part; and of those materials
// (sRGB). material_file: as the OBJ names it.
std::string ToObj(const Mesh& mesh, const std::string& material_file);
std::string ToMtl(const ModelColors& colors);

// The same of a mesh for readers that give a mesh one material: texture coordinates choose the
// part's column of a picture of kMeshPartCount columns of equal width.
std::string ToPaletteObj(const Mesh& mesh);

// The same of a surface with its normals, moved by offset_m, all of one material "surface".
std::string ToObj(const SurfaceMesh& mesh, const Eigen::Vector3f& offset_m);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_SIMULATORS_OBJ_MESH_H_
