#include "latticeworld/scene/densities.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace latticeworld {
namespace {

constexpr double kHectare_m2 = 10000.0;

// One row a class, one column a kind in the order of AssetKind.
struct Row {
  char letter;
  std::array<double, 8> per_hectare;
};

//                                      tree bush stone building branch grass flower crop
constexpr std::array<Row, 7> kSuburb = {{{'A', {2, 5, 1, 0, 0, 60, 20, 1600}},
                                         {'B', {15, 20, 1, 40, 0, 150, 60, 0}},
                                         {'D', {2, 10, 30, 0, 2, 40, 5, 0}},
                                         {'F', {400, 150, 15, 0, 80, 250, 60, 0}},
                                         {'G', {6, 30, 8, 0, 1, 1100, 350, 0}},
                                         {'R', {0, 0, 0, 0, 0, 0, 0, 0}},
                                         {'W', {0, 0, 0, 0, 0, 0, 0, 0}}}};
constexpr std::array<Row, 5> kWild = {{{'B', {12, 200, 15, 0, 3, 900, 300, 0}},
                                       {'F', {400, 150, 15, 0, 80, 250, 60, 0}},
                                       {'R', {8, 30, 120, 0, 2, 60, 15, 0}},
                                       {'S', {25, 10, 40, 0, 2, 0, 0, 0}},
                                       {'W', {0, 0, 0, 0, 0, 0, 0, 0}}}};

template <typename Rows>
double Find(const Rows& rows, char letter, AssetKind kind) {
  for (const Row& row : rows) {
    if (row.letter == letter) return row.per_hectare[static_cast<int>(kind)];
  }
  return 0.0;
}

double SumOf(const WeightGrid& weight) {
  std::uint64_t sum = 0;
  for (const std::uint8_t level : weight.levels()) sum += level;
  return static_cast<double>(sum) / WeightGrid::kLevels;
}

}  // namespace

double PerHectare(Vocabulary vocabulary, char letter, AssetKind kind) {
  // The columns follow the enum; this is where a kind that moves would show.
  static_assert(static_cast<int>(AssetKind::kBuilding) == 3 &&
                static_cast<int>(AssetKind::kDeadBranch) == 4 &&
                static_cast<int>(AssetKind::kCrop) == 7);
  return vocabulary == Vocabulary::kSuburb ? Find(kSuburb, letter, kind)
                                           : Find(kWild, letter, kind);
}

double ExpectedAssets(const ClassWeights& weights, const EnvironmentConfig& environment,
                      const GridGeometry& geometry) {
  double expected = 0.0;
  for (const ClassWeight& item : weights.classes) {
    double per_hectare = 0.0;
    for (const auto& kind : EnumNames(AssetKind{})) {
      per_hectare += PerHectare(weights.vocabulary, item.letter, kind.value) *
                     environment.fine_of(TypeOf(kind.value)).density;
    }
    expected += per_hectare / kHectare_m2 * SumOf(item.weight);
  }
  return expected * geometry.resolution_m() * geometry.resolution_m();
}

DensityField::DensityField(const ClassWeights& weights, const EnvironmentConfig& environment,
                           AssetKind kind, double thinning) {
  const double density = environment.fine_of(TypeOf(kind)).density * thinning;
  for (const ClassWeight& item : weights.classes) {
    const double per_m2 = PerHectare(weights.vocabulary, item.letter, kind) * density / kHectare_m2;
    if (per_m2 <= 0.0) continue;
    terms_.push_back({&item.weight, per_m2});
    largest_per_m2_ = std::max(largest_per_m2_, per_m2);
  }
}

double DensityField::per_m2_At(CellIndex cell) const {
  double sum = 0.0;
  for (const Term& term : terms_) sum += term.per_m2 * (*term.weight)[cell];
  return sum;
}

double DensityField::Expected(const GridGeometry& geometry) const {
  double sum = 0.0;
  for (const Term& term : terms_) sum += SumOf(*term.weight) * term.per_m2;
  return sum * geometry.resolution_m() * geometry.resolution_m();
}

}  // namespace latticeworld
