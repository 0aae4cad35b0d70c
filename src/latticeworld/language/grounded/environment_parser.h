#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_PARSER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_PARSER_H_

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/environment/agent_group.h"
#include "latticeworld/environment/attributes.h"
#include "latticeworld/environment/fine_attributes.h"

namespace latticeworld {

// Agents as an instruction asks for them, before they are fitted to a world.
struct AgentWish {
  AgentCategory category = AgentCategory::kSheep;
  int quantity = 1;                 // as said; may be beyond the limits
  std::optional<AgentState> state;  // nullopt: not said
  Region position = Region::kAnywhere;
  std::string words;
};

// What an environment instruction says; what it leaves open is nullopt.
struct EnvironmentReading {
  std::optional<TerrainType> terrain_type;
  std::optional<Season> season;
  std::optional<ArtisticStyle> artistic_style;
  std::optional<Weather> weather;
  std::optional<TimeOfDay> time_of_day;
  std::vector<std::pair<AssetType, double>> densities;
  std::vector<AgentWish> agents;
  std::vector<std::string> warnings;
};

// Any UTF-8 text gives a reading; what it cannot read becomes a warning that quotes the words.
EnvironmentReading ParseEnvironmentInstruction(std::string_view instruction);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_PARSER_H_
