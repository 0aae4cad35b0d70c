#ifndef LATTICEWORLD_ENVIRONMENT_RULES_H_
#define LATTICEWORLD_ENVIRONMENT_RULES_H_

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/environment/attributes.h"
#include "latticeworld/environment/fine_attributes.h"
#include "latticeworld/environment/fine_parameter.h"

namespace latticeworld {

// Coarse values bound fine ones: what data/coarse_to_fine.json says. Terrain type, season, weather
// and time of day set ranges, distributions and exclusions; the artistic style binds nothing.

// A rule by its name and its reason, for messages.
struct RuleLabel {
  std::string id;   // "winter-growth"
  std::string why;  // one sentence
};

// A seasonal variant or material of a type. Views and labels last as long as the catalogue and the
// rules.
struct ValueBound {
  std::string_view name;
  double weight = 1.0;  // how often it is drawn, relative to the other legal ones, > 0
  const RuleLabel* excluded = nullptr;  // the first rule that excludes it; null: legal

  bool legal() const { return excluded == nullptr; }
};

// A continuous parameter. Drawn within [draw_low, draw_high], a part of the range: evenly, or by a
// triangular distribution with its mode at `typical`.
struct NumberBound {
  Range range{0.0, 1.0};               // never empty
  const RuleLabel* lowest = nullptr;   // what set range.low; null: the parameter itself
  const RuleLabel* highest = nullptr;  // range.high
  double typical = 0.0;                // within the range
  double draw_low = 0.0;
  double draw_high = 1.0;
  bool draw_evenly = false;
};

// What is legal and usual for the fine attributes of one asset type.
struct FineBounds {
  AssetType type = AssetType::kGrass;
  std::vector<ValueBound> season_variants;  // by index, as in the catalogue; one is legal at least
  std::vector<ValueBound> materials;        // the same
  // The bounds by FineParameter; nullopt: the type has no such parameter.
  std::array<std::optional<NumberBound>, kFineParameterCount> numbers;

  const std::optional<NumberBound>& number(FineParameter parameter) const {
    return numbers[static_cast<std::size_t>(parameter)];
  }
};

FineBounds BoundsOf(const CoarseAttributes& coarse, AssetType type, const Catalogue& catalogue);
FineBounds BoundsOf(const CoarseAttributes& coarse, AssetType type);  // of Catalogue::BuiltIn()

// The rule that a value breaks, and what is legal instead; "" where it keeps to the bounds:
// "the rule own-season excludes it (foliage, bloom, crops and ice show ...); legal are winter pine,
// ..." A name that is not among the values is told so.
std::string BreachOf(const std::vector<ValueBound>& values, std::string_view name);
// "the rule winter-growth allows 0.9 at most (in winter meadows, flowers and fields die back)".
std::string BreachOf(const NumberBound& bound, double value);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ENVIRONMENT_RULES_H_
