#ifndef LATTICEWORLD_EXPORTING_GLTF_MODEL_LIBRARY_H_
#define LATTICEWORLD_EXPORTING_GLTF_MODEL_LIBRARY_H_

#include <string>

#include "latticeworld/common/result.h"

namespace latticeworld {

class SpeciesCatalogue;
struct Asset;
struct Scene;

// Which mesh an asset has: "<model>/<seasonal variant>/<individual>", the individual 0 to 3; the
// names are the catalogue's, as assets.csv has them.
std::string ModelNameOf(const Scene& scene, const Asset& asset);

// The meshes that a scene is furnished with, as one glTF 2.0 binary file in glTF's axes (y up), a
// node a mesh. "<ModelNameOf>/<level>": for every model that the scene uses and each level of
// detail, 0 the finest; in its unit box (meshes/mesh.h), for an asset to be scaled by (half length,
// height, half width), turned about y by its yaw and moved to its place. "agent/<species>": for
// every species, in metres (body_meshes.h). "prop/<kind>/<level>": for every kind, of size 1,
// the same at each level.
//
// Nothing stands anywhere: all are at the origin. Materials are named "<mesh>/<part>" and have the
// mean colour of the scene's things of that mesh; triangles are shaded
// flat; vertices are quantized (KHR_mesh_quantization). Errors:
// RESOURCE_EXHAUSTED, INTERNAL.
Result<std::string> ModelLibraryGlb(const Scene& scene, const SpeciesCatalogue& species);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_GLTF_MODEL_LIBRARY_H_
