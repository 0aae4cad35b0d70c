#ifndef LATTICEWORLD_TESTS_MESHES_SILHOUETTE_H_
#define LATTICEWORLD_TESTS_MESHES_SILHOUETTE_H_

#include "latticeworld/meshes/mesh.h"

namespace latticeworld {

// The share of the unit box's face across `axis` (0: x, 1: y, 2: z) that the mesh covers, what is
// below the ground left out.
double CoveredShare(const Mesh& mesh, int axis);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_MESHES_SILHOUETTE_H_
