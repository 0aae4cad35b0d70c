#include "latticeworld/environment/rule_book.h"

#include <algorithm>

#include "latticeworld/common/check.h"

namespace latticeworld {
namespace {

template <typename Enum>
bool Has(std::uint32_t set, Enum value) {
  return (set >> static_cast<unsigned>(value) & 1u) != 0;
}

// A value as selectors see it; materials have no seasons and no snow.
struct Candidate {
  std::string_view name;
  bool in_season = true;
  double snow = 0.0;
};

std::vector<Candidate> SeasonCandidates(const CoarseAttributes& coarse, AssetType type,
                                        const Catalogue& catalogue) {
  std::vector<Candidate> candidates;
  for (const SeasonVariant& variant : catalogue.season_variants(type)) {
    candidates.push_back(
        {variant.name, variant.seasons[static_cast<std::size_t>(coarse.season)], variant.snow});
  }
  return candidates;
}

std::vector<Candidate> MaterialCandidates(AssetType type, const Catalogue& catalogue) {
  std::vector<Candidate> candidates;
  for (const Material& material : catalogue.materials(type)) candidates.push_back({material.name});
  return candidates;
}

bool Selects(const ValueSelector& selector, const Candidate& candidate) {
  return HasWords(candidate.name, selector.words) &&
         (!selector.snow_above || candidate.snow > *selector.snow_above) &&
         (!selector.out_of_season || !candidate.in_season);
}

void Exclude(const std::vector<ValueSelector>& selectors, const std::vector<Candidate>& candidates,
             const RuleLabel& label, std::vector<ValueBound>* values) {
  std::vector<ValueBound*> excluded;
  std::size_t legal = 0;
  for (std::size_t i = 0; i < values->size(); ++i) {
    ValueBound& value = (*values)[i];
    if (!value.legal()) continue;
    ++legal;
    if (std::any_of(selectors.begin(), selectors.end(), [&](const ValueSelector& selector) {
          return Selects(selector, candidates[i]);
        })) {
      excluded.push_back(&value);
    }
  }
  if (excluded.size() == legal) return;  // something always stays legal
  for (ValueBound* value : excluded) value->excluded = &label;
}

void Apply(const ValuesEffect& effect, const std::vector<Candidate>& candidates,
           const RuleLabel& label, std::vector<ValueBound>* values) {
  if (!effect.exclude.empty()) Exclude(effect.exclude, candidates, label, values);
  for (const WordWeight& weight : effect.weights) {
    for (ValueBound& value : *values) {
      if (HasWords(value.name, weight.words)) value.weight *= weight.times;
    }
  }
}

void Apply(const NumberEffect& effect, const RuleLabel& label, NumberBound* bound) {
  if (effect.min && *effect.min > bound->range.low) {
    bound->range.low = std::min(*effect.min, bound->range.high);
    bound->lowest = &label;
  }
  if (effect.max && *effect.max < bound->range.high) {
    bound->range.high = std::max(*effect.max, bound->range.low);
    bound->range.high_open = false;
    bound->highest = &label;
  }
  if (effect.typical) bound->typical = *effect.typical;
  bound->typical *= effect.factor;
  if (effect.draw) {
    bound->draw_low = (*effect.draw)[0];
    bound->draw_high = (*effect.draw)[1];
  }
  if (effect.evenly) bound->draw_evenly = *effect.evenly;
}

NumberBound BoundOf(FineParameter parameter) {
  NumberBound bound;
  bound.range = RangeOf(parameter);
  bound.typical = ValueOf(FineAttribute(), parameter);
  bound.draw_low = bound.range.low;
  bound.draw_high = bound.range.high;
  return bound;
}

void KeepWithin(NumberBound* bound) {
  const auto within = [&](double value) {
    return std::max(bound->range.low, std::min(bound->range.high, value));
  };
  bound->typical = within(bound->typical);
  bound->draw_low = within(bound->draw_low);
  bound->draw_high = within(bound->draw_high);
}

}  // namespace

bool HasWords(std::string_view name, std::string_view words) {
  for (std::size_t at = name.find(words); at != name.npos; at = name.find(words, at + 1)) {
    const std::size_t end = at + words.size();
    if ((at == 0 || name[at - 1] == ' ') && (end == name.size() || name[end] == ' ')) return true;
  }
  return words.empty();
}

bool RuleCondition::Holds(const CoarseAttributes& coarse) const {
  return Has(terrain_types, coarse.terrain_type) && Has(seasons, coarse.season) &&
         Has(weathers, coarse.weather) && Has(times_of_day, coarse.time_of_day);
}

bool Rule::Holds(const CoarseAttributes& coarse) const {
  return std::any_of(when.begin(), when.end(),
                     [&](const RuleCondition& condition) { return condition.Holds(coarse); });
}

FineBounds RuleBook::BoundsOf(const CoarseAttributes& coarse, AssetType type,
                              const Catalogue& catalogue) const {
  const std::vector<Candidate> variants = SeasonCandidates(coarse, type, catalogue);
  const std::vector<Candidate> materials = MaterialCandidates(type, catalogue);
  FineBounds bounds;
  bounds.type = type;
  for (const Candidate& variant : variants) bounds.season_variants.push_back({variant.name});
  for (const Candidate& material : materials) bounds.materials.push_back({material.name});
  for (const auto& entry : EnumNames(FineParameter{})) {
    if (!HasParameter(catalogue.ValuesOf(type), entry.value)) continue;
    bounds.numbers[static_cast<std::size_t>(entry.value)] = BoundOf(entry.value);
  }
  for (const Rule& rule : rules_) {
    if (!rule.Holds(coarse)) continue;
    for (const RuleEffect& effect : rule.then) {
      if (std::find(effect.types.begin(), effect.types.end(), type) == effect.types.end()) continue;
      Apply(effect.season_variants, variants, rule.label, &bounds.season_variants);
      Apply(effect.materials, materials, rule.label, &bounds.materials);
      for (std::size_t i = 0; i < effect.numbers.size(); ++i) {
        if (effect.numbers[i] && bounds.numbers[i]) {
          Apply(*effect.numbers[i], rule.label, &*bounds.numbers[i]);
        }
      }
    }
  }
  for (std::optional<NumberBound>& bound : bounds.numbers) {
    if (bound) KeepWithin(&*bound);
  }
  return bounds;
}

const RuleBook& RuleBook::BuiltIn() {
  static const RuleBook book = [] {
    Result<RuleBook> parsed = Parse(RuleText());
    LW_CHECK(parsed.ok(), parsed.status().ToString());
    return std::move(parsed).value();
  }();
  return book;
}

}  // namespace latticeworld
