#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_WORDS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_WORDS_H_

#include <optional>

#include "latticeworld/environment/agent_group.h"
#include "latticeworld/environment/attributes.h"
#include "latticeworld/environment/fine_attributes.h"
#include "latticeworld/language/grounded/phrase_table.h"

namespace latticeworld {

// What a phrase gives away about the coarse attributes; a strong one says it, a weak one hints.
struct AttributeHint {
  std::optional<TerrainType> terrain_type;
  std::optional<Season> season;
  std::optional<ArtisticStyle> artistic_style;
  std::optional<Weather> weather;
  std::optional<TimeOfDay> time_of_day;
  bool weak = false;
};
const PhraseTable<AttributeHint>& AttributeWords();

struct CategoryWord {
  AgentCategory category = AgentCategory::kSheep;
  bool exact = true;  // false: only the nearest category ("wolf")
};
const PhraseTable<CategoryWord>& CategoryWords();

const PhraseTable<AgentState>& StateWords();

// "several" and its like: a number of agents.
const PhraseTable<int>& VagueNumberWords();

// Asset types by the words that speak of their density.
const PhraseTable<AssetType>& AssetWords();
// Densities: "dense" 0.9, "sparse" 0.15.
const PhraseTable<double>& DensityWords();

enum class EnvironmentWord { kFunction, kNo, kBreak };
const PhraseTable<EnvironmentWord>& EnvironmentSmallWords();

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_WORDS_H_
