#ifndef LATTICEWORLD_SCENE_VEGETATION_PATCH_NOISE_H_
#define LATTICEWORLD_SCENE_VEGETATION_PATCH_NOISE_H_

#include <cstdint>

#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

// Smooth patches over the plane: value noise (random values on a lattice, smoothly interpolated) of
// two octaves, for what grows in groups. Cheap at single points, unlike FractalNoise, which fills
// whole grids.
class PatchNoise {
 public:
  // wavelength_m: width of a patch and the gap beside it, > 0.
  PatchNoise(std::uint64_t seed, double wavelength_m);

  // Returns a value in [0, 1], about 0.5 in the mean, nearly evenly distributed.
  double At(WorldPoint point) const;

 private:
  std::uint64_t seed_;
  double per_m_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_VEGETATION_PATCH_NOISE_H_
