#include "latticeworld/language/remote/rule_tables.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/agent_group.h"
#include "latticeworld/environment/fine_attributes.h"
#include "latticeworld/environment/rules.h"

namespace latticeworld {
namespace {

// One coarse value and the others as they usually are.
template <typename Enum>
CoarseAttributes With(Enum CoarseAttributes::*attribute, Enum value) {
  CoarseAttributes coarse;
  coarse.*attribute = value;
  return coarse;
}

bool IsLegal(const CoarseAttributes& coarse, AssetType type, std::size_t variant,
             const Catalogue& catalogue) {
  return BoundsOf(coarse, type, catalogue).season_variants[variant].legal();
}

std::string SeasonsOf(AssetType type, std::size_t variant, const Catalogue& catalogue) {
  std::vector<std::string> seasons;
  bool snowfall_is_enough = true;
  for (const auto& entry : EnumNames(Season{})) {
    CoarseAttributes coarse = With(&CoarseAttributes::season, entry.value);
    if (IsLegal(coarse, type, variant, catalogue)) seasons.emplace_back(entry.name);
    coarse.weather = Weather::kSnow;
    snowfall_is_enough = snowfall_is_enough && IsLegal(coarse, type, variant, catalogue);
  }
  if (seasons.size() == EnumNames(Season{}).size()) return "any season";
  return Join(seasons, ", ") + (snowfall_is_enough ? " or weather snow" : "");
}

// What coarse attributes forbid of a type that some of `others` allow.
class Limits {
 public:
  Limits(const CoarseAttributes& coarse, const std::vector<CoarseAttributes>& others,
         AssetType type, const Catalogue& catalogue, std::vector<std::string>* limits)
      : name_(NameOf(type)), bounds_(BoundsOf(coarse, type, catalogue)), limits_(limits) {
    for (const CoarseAttributes& other : others) {
      others_.push_back(BoundsOf(other, type, catalogue));
    }
  }

  void AddValues(std::vector<ValueBound> FineBounds::*values) {
    for (std::size_t i = 0; i < (bounds_.*values).size(); ++i) {
      const ValueBound& value = (bounds_.*values)[i];
      if (value.legal() ||
          !Any([&](const FineBounds& other) { return (other.*values)[i].legal(); }))
        continue;
      limits_->push_back("no " + name_ + " of " + std::string(value.name));
    }
  }

  void AddNumber(FineParameter parameter) {
    const auto& number = bounds_.number(parameter);
    if (!number) return;
    const std::string what = name_ + " " + std::string(NameOf(parameter)) + " ";
    const Range& range = number->range;
    if (Any([&](const FineBounds& other) {
          return other.number(parameter)->range.low < range.low;
        }))
      limits_->push_back(what + FormatDouble(range.low) + " at least");
    if (Any([&](const FineBounds& other) {
          return other.number(parameter)->range.high > range.high;
        }))
      limits_->push_back(what + FormatDouble(range.high) + " at most");
  }

 private:
  template <typename Holds>
  bool Any(const Holds& holds) const {
    return std::any_of(others_.begin(), others_.end(), holds);
  }

  std::string name_;
  FineBounds bounds_;
  std::vector<FineBounds> others_;
  std::vector<std::string>* limits_;
};

// A line for each value of the attribute that forbids something. Seasonal variants only where
// asked, because those that go by seasons stand in a table of their own.
template <typename Enum>
void AddLimits(Enum CoarseAttributes::*attribute, bool variants,
               const std::vector<CoarseAttributes>& others, const Catalogue& catalogue,
               std::vector<std::string>* lines) {
  for (const auto& entry : EnumNames(Enum{})) {
    std::vector<std::string> texts;
    for (const auto& type : EnumNames(AssetType{})) {
      Limits limits(With(attribute, entry.value), others, type.value, catalogue, &texts);
      if (variants) limits.AddValues(&FineBounds::season_variants);
      limits.AddValues(&FineBounds::materials);
      for (const auto& parameter : EnumNames(FineParameter{})) limits.AddNumber(parameter.value);
    }
    if (texts.empty()) continue;
    lines->push_back("  " + std::string(entry.name) + ": " + Join(texts, ", "));
  }
}

}  // namespace

std::string SeasonTable(const Catalogue& catalogue) {
  std::vector<std::string> lines;
  for (const auto& entry : EnumNames(AssetType{})) {
    std::vector<std::string> variants;
    const auto& names = catalogue.ValuesOf(entry.value).season_variants;
    for (std::size_t i = 0; i < names.size(); ++i) {
      variants.push_back(std::string(names[i]) + " (" + SeasonsOf(entry.value, i, catalogue) + ")");
    }
    lines.push_back("  " + std::string(entry.name) + ": " + Join(variants, ", "));
  }
  return Join(lines, "\n");
}

std::string LimitTable(const Catalogue& catalogue) {
  const std::vector<CoarseAttributes> usual(1);
  std::vector<CoarseAttributes> seasons;
  for (const auto& entry : EnumNames(Season{})) {
    seasons.push_back(With(&CoarseAttributes::season, entry.value));
  }
  std::vector<std::string> lines;
  AddLimits(&CoarseAttributes::terrain_type, true, usual, catalogue, &lines);
  AddLimits(&CoarseAttributes::season, false, seasons, catalogue, &lines);
  AddLimits(&CoarseAttributes::weather, true, usual, catalogue, &lines);
  AddLimits(&CoarseAttributes::time_of_day, true, usual, catalogue, &lines);
  return Join(lines, "\n");
}

std::string StateTable() {
  std::vector<std::string> lines;
  for (const auto& category : EnumNames(AgentCategory{})) {
    std::vector<std::string> states;
    for (const auto& state : EnumNames(AgentState{})) {
      if (CanBe(category.value, state.value)) states.emplace_back(state.name);
    }
    lines.push_back("  " + std::string(category.name) + ": " + Join(states, ", "));
  }
  return Join(lines, "\n");
}

}  // namespace latticeworld
