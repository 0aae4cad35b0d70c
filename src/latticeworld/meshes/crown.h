#ifndef LATTICEWORLD_MESHES_CROWN_H_
#define LATTICEWORLD_MESHES_CROWN_H_

#include <cmath>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/meshes/mesh_builder.h"

namespace latticeworld {

// The space that a crown fills: round about the z axis, with bulges.
struct Crown {
  float base_m = 0.0f, top_m = 1.0f, radius_m = 1.0f;
  float widest = 0.4f;  // share of its length
  float bulge = 0.15f;
  float phases_rad[3] = {};

  // Its radius at a height and in a direction [m].
  float RadiusAt(float z_m, float angle_rad) const;
  // Points in it, evenly spread; `shell` in [0, 1]: how much they keep to its outside.
  std::vector<Vec3> Fill(int count, float shell, RandomStream* random) const;
  // Returns the geometric mean of its radius and half its length [m].
  float size_m() const { return std::sqrt(radius_m * 0.5f * (top_m - base_m)); }
  Vec3 centre_m() const { return {0.0f, 0.0f, base_m + 0.45f * (top_m - base_m)}; }
};

Crown DrawCrown(float base_m, float top_m, float radius_m, float widest, float bulge,
                RandomStream* random);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MESHES_CROWN_H_
