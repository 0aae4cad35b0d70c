#include "latticeworld/language/remote/rule_tables.h"

#include <string_view>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/agent_group.h"
#include "latticeworld/environment/fine_attributes.h"
#include "latticeworld/environment/season_rules.h"

namespace latticeworld {
namespace {

std::string SeasonsOf(AssetType type, std::string_view variant) {
  std::vector<std::string> seasons;
  bool snowfall_is_enough = true;
  for (const auto& entry : EnumNames(Season{})) {
    CoarseAttributes coarse;
    coarse.season = entry.value;
    coarse.weather = Weather::kSunny;
    if (IsAllowed(type, variant, coarse)) seasons.emplace_back(entry.name);
    coarse.weather = Weather::kSnow;
    snowfall_is_enough = snowfall_is_enough && IsAllowed(type, variant, coarse);
  }
  if (seasons.size() == EnumNames(Season{}).size()) return "any season";
  return Join(seasons, ", ") + (snowfall_is_enough ? " or weather snow" : "");
}

}  // namespace

std::string SeasonTable() {
  std::vector<std::string> lines;
  for (const auto& entry : EnumNames(AssetType{})) {
    std::vector<std::string> variants;
    for (const std::string_view variant : ValuesOf(entry.value).season_variants) {
      variants.push_back(std::string(variant) + " (" + SeasonsOf(entry.value, variant) + ")");
    }
    lines.push_back("  " + std::string(entry.name) + ": " + Join(variants, ", "));
  }
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
