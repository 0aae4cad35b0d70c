#ifndef LATTICEWORLD_EXPORTING_SIMULATORS_USD_LAND_H_
#define LATTICEWORLD_EXPORTING_SIMULATORS_USD_LAND_H_

#include "latticeworld/exporting/ground_mesh.h"

namespace latticeworld {

class UsdText;
struct Scene;

// Materials of the ground, as children of the prim "looks": "ground" with ground.jpg, and
// "friction_<class>" of every class of ground and "friction_ground", the mean over the mesh.
// The prim "ground": a mesh that collides, with a subset of its triangles a class.
void AddUsdGround(const Scene& scene, const SurfaceLattice& lattice, UsdText* looks,
                  UsdText* world);

// The prim "water", a mesh without collision; nothing where there is none.
void AddUsdWater(const Scene& scene, const SurfaceLattice& lattice, UsdText* world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_SIMULATORS_USD_LAND_H_
