#ifndef LATTICEWORLD_SCENE_DENSITIES_H_
#define LATTICEWORLD_SCENE_DENSITIES_H_

#include <vector>

#include "latticeworld/environment/environment_config.h"
#include "latticeworld/layout/class_weights.h"
#include "latticeworld/scene/asset.h"

namespace latticeworld {

// How many of a kind stand on a hectare that is wholly of the class, at density 1 of the fine
// attribute TypeOf(kind): 400 trees in a forest, 10 buildings in a built-up area. Temperate stands:
// 300 to 1000 stems a hectare for grown forest (Burkhart and Tome 2012, Modeling Forest Trees and
// Stands). Ground cover counts tufts and clumps, not blades, and is thin enough that no hectare
// holds more than kMostPerHectare assets.
double PerHectare(Vocabulary vocabulary, char letter, AssetKind kind);
inline constexpr double kMostPerHectare = 2000.0;

// How many assets of all kinds a world has at these densities if nothing stands in the way.
double ExpectedAssets(const ClassWeights& weights, const EnvironmentConfig& environment,
                      const GridGeometry& geometry);

// The density of one kind over a world: class weights x PerHectare x fine density x thinning.
class DensityField {
 public:
  // weights must outlive the field. thinning: [0, 1].
  DensityField(const ClassWeights& weights, const EnvironmentConfig& environment, AssetKind kind,
               double thinning);

  double largest_per_m2() const { return largest_per_m2_; }
  double per_m2_At(CellIndex cell) const;
  // How many of the kind a world has if nothing stands in the way.
  double Expected(const GridGeometry& geometry) const;

 private:
  struct Term {
    const WeightGrid* weight;
    double per_m2;
  };
  std::vector<Term> terms_;
  double largest_per_m2_ = 0.0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_DENSITIES_H_
