#ifndef LATTICEWORLD_SCENE_VEGETATION_THINNING_H_
#define LATTICEWORLD_SCENE_VEGETATION_THINNING_H_

#include <array>
#include <cstddef>

#include "latticeworld/catalogue/asset_kind.h"

namespace latticeworld {

struct Placement;

// A number for each kind, by AssetKind.
using OfKinds = std::array<double, kAssetKindCount>;

// Factors on the densities of the kinds that keep a large world within a number of assets. What
// covers the ground (bushes, grass tufts, flowers, crops) gives way first, down to a tenth; then
// trees, stones and dead branches do, and the cover with them. Buildings never do.
class Thinning {
 public:
  Thinning() { factors_.fill(1.0); }
  // expected: how many of each kind there would be.
  Thinning(const OfKinds& expected, double most);

  double operator[](AssetKind kind) const { return factors_[static_cast<std::size_t>(kind)]; }

 private:
  OfKinds factors_;
};

// How many of each kind a world has at its densities, before thinning, if nothing stands in the
// way: by its classes, along shores, in gardens and in orchards.
OfKinds ExpectedAssets(const Placement& placement);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_VEGETATION_THINNING_H_
