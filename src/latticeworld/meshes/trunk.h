#ifndef LATTICEWORLD_MESHES_TRUNK_H_
#define LATTICEWORLD_MESHES_TRUNK_H_

#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/meshes/mesh_builder.h"

namespace latticeworld {

// A trunk's axis from below the ground to its top: upright to breast height and winding a little
// above.
struct Trunk {
  std::vector<Vec3> axis_m;
  std::vector<float> lengths_m;  // of the way along it, from where the crown begins
};
Trunk DrawTrunk(float height_m, float crown_base_m, float top_m, RandomStream* random);

// A model's trunk at breast height, as a share of its crown's radius.
float TrunkShare(const AssetModel& model);

// Adds it to a builder whose crown has been fitted to the unit box: root flare, taper, and at
// breast height (1.3 m) the radius given [unit box].
void AddFittedTrunk(const Trunk& trunk, float height_m, float breast_radius, int detail,
                    MeshBuilder* builder);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MESHES_TRUNK_H_
