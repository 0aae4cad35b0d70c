#ifndef LATTICEWORLD_MESHES_ICOSPHERE_H_
#define LATTICEWORLD_MESHES_ICOSPHERE_H_

#include <array>
#include <cstdint>
#include <vector>

#include "latticeworld/meshes/mesh_builder.h"

namespace latticeworld {

struct Icosphere {
  std::vector<Vec3> vertices;  // on the unit sphere
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// An icosahedron with each face cut into four `cuts` times: 20, 80, 320 triangles.
Icosphere MakeIcosphere(int cuts);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MESHES_ICOSPHERE_H_
