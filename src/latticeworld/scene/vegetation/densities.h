#ifndef LATTICEWORLD_SCENE_VEGETATION_DENSITIES_H_
#define LATTICEWORLD_SCENE_VEGETATION_DENSITIES_H_

#include <cstdint>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/layout/class_weights.h"

namespace latticeworld {

inline constexpr double kHectare_m2 = 10000.0;

// The density of one kind over a world: class weights x Catalogue::PerHectare x fine density x
// thinning.
class DensityField {
 public:
  // One class of the layout on which the kind stands.
  struct Term {
    char letter;
    double per_m2;  // where the class has all the weight
    const WeightGrid* weight;

    double WeightAt(CellIndex cell) const { return (*weight)[cell]; }
  };

  // weights must outlive the field. thinning: [0, 1].
  DensityField(const ClassWeights& weights, const EnvironmentConfig& environment,
               const Catalogue& catalogue, AssetKind kind, double thinning);

  const std::vector<Term>& terms() const { return terms_; }  // per_m2 > 0
  double largest_per_m2() const { return largest_per_m2_; }
  double per_m2_At(CellIndex cell) const;
  // How many of the kind a world has if nothing stands in the way.
  double Expected(const GridGeometry& geometry) const;

 private:
  std::vector<Term> terms_;
  double largest_per_m2_ = 0.0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_VEGETATION_DENSITIES_H_
