#include "latticeworld/environment/season_rules.h"

#include <algorithm>

namespace latticeworld {
namespace {

struct Rule {
  std::string_view word;  // in the variant's name
  bool spring, summer, autumn, winter;
};

// The first rule whose word a variant's name has decides; a variant without any goes with all
// seasons.
constexpr Rule kRules[] = {
    {"spring", true, false, false, false}, {"summer", false, true, false, false},
    {"autumn", false, false, true, false}, {"winter", false, false, false, true},
    {"frozen", false, false, false, true}, {"blooming", true, true, true, false},
    {"lush", true, true, true, false},     {"green", true, true, true, false},
    {"ripe", false, true, true, false},    {"sown", true, false, true, true},
    {"stubble", false, false, true, true},
};

bool NeedsSnow(std::string_view variant) { return variant.find("snow-covered") != variant.npos; }

bool SnowLies(const CoarseAttributes& coarse) {
  return coarse.season == Season::kWinter || coarse.weather == Weather::kSnow;
}

}  // namespace

bool IsAllowed(AssetType type, std::string_view season_variant, const CoarseAttributes& coarse) {
  const auto& variants = ValuesOf(type).season_variants;
  if (std::find(variants.begin(), variants.end(), season_variant) == variants.end()) return false;
  if (NeedsSnow(season_variant)) return SnowLies(coarse);
  for (const Rule& rule : kRules) {
    if (season_variant.find(rule.word) == std::string_view::npos) continue;
    switch (coarse.season) {
      case Season::kSpring:
        return rule.spring;
      case Season::kSummer:
        return rule.summer;
      case Season::kAutumn:
        return rule.autumn;
      case Season::kWinter:
        return rule.winter;
    }
  }
  return true;
}

}  // namespace latticeworld
