#include "latticeworld/scene/vegetation/densities.h"

#include <algorithm>

#include "latticeworld/scene/asset.h"

namespace latticeworld {
namespace {

double SumOf(const WeightGrid& weight) {
  std::uint64_t sum = 0;
  for (const std::uint8_t level : weight.levels()) sum += level;
  return static_cast<double>(sum) / WeightGrid::kLevels;
}

}  // namespace

DensityField::DensityField(const ClassWeights& weights, const EnvironmentConfig& environment,
                           const Catalogue& catalogue, AssetKind kind, double thinning) {
  const double density = environment.fine_of(TypeOf(kind)).density * thinning;
  for (const ClassWeight& item : weights.classes) {
    const double per_m2 =
        catalogue.PerHectare(kind, NameOf(weights.vocabulary), item.letter) * density / kHectare_m2;
    if (per_m2 <= 0.0) continue;
    terms_.push_back({item.letter, per_m2, &item.weight});
    largest_per_m2_ = std::max(largest_per_m2_, per_m2);
  }
}

double DensityField::per_m2_At(CellIndex cell) const {
  double sum = 0.0;
  for (const Term& term : terms_) sum += term.per_m2 * term.WeightAt(cell);
  return sum;
}

double DensityField::Expected(const GridGeometry& geometry) const {
  double sum = 0.0;
  for (const Term& term : terms_) sum += SumOf(*term.weight) * term.per_m2;
  return sum * geometry.resolution_m() * geometry.resolution_m();
}

}  // namespace latticeworld
