// JSON Schema of the environment, made from the catalogue and the rules that the parser obeys.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/environment/ranges.h"
#include "latticeworld/environment/rule_book.h"

namespace latticeworld {
namespace {

using Json = nlohmann::ordered_json;

template <typename Enum>
Json NamesSchema() {
  Json names = Json::array();
  for (const auto& entry : EnumNames(Enum{})) names.push_back(entry.name);
  return {{"enum", names}};
}

Json NumberSchema(const Range& range) {
  return {{"type", "number"},
          {"minimum", range.low},
          {range.high_open ? "exclusiveMaximum" : "maximum", range.high}};
}

// An object that has exactly these properties.
Json ObjectSchema(const Json& properties) {
  Json required = Json::array();
  for (const auto& [key, value] : properties.items()) required.push_back(key);
  return {{"type", "object"},
          {"properties", properties},
          {"required", required},
          {"additionalProperties", false}};
}

Json FineSchema(const AssetTypeValues& values) {
  Json properties;
  properties["season_variant"] = {{"enum", values.season_variants}};
  properties["material"] = {{"enum", values.materials}};
  properties["density"] = NumberSchema(kDensityRange);
  if (values.has_rotation) {
    properties["rotation"] = {{"type", "array"},
                              {"description", "Euler angles roll, pitch, yaw [degrees]"},
                              {"items", NumberSchema(kRotationRange)},
                              {"minItems", 3},
                              {"maxItems", 3}};
  }
  if (values.has_scale) properties["scale"] = NumberSchema(kScaleRange);
  if (values.has_height) properties["height"] = NumberSchema(kHeightRange);
  if (values.has_wind) properties["wind"] = NumberSchema(kWindRange);
  if (values.has_slope) properties["slope"] = NumberSchema(kSlopeRange);
  return ObjectSchema(properties);
}

bool Binds(const RuleEffect& effect) {
  return !effect.season_variants.exclude.empty() || !effect.materials.exclude.empty() ||
         std::any_of(effect.numbers.begin(), effect.numbers.end(),
                     [](const auto& number) { return number && (number->min || number->max); });
}

// The rules that make a document illegal which the schema lets through.
std::string RuleDescription() {
  std::vector<std::string> rules;
  for (const Rule& rule : RuleBook::BuiltIn().rules()) {
    if (std::any_of(rule.then.begin(), rule.then.end(), Binds)) {
      rules.push_back(rule.label.id + " (" + rule.label.why + ")");
    }
  }
  return "Beyond this schema rules bind fine values to coarse ones: " + Join(rules, "; ") + ".";
}

}  // namespace

std::string EnvironmentSchema(const Catalogue& catalogue) {
  Json fine;
  for (const auto& entry : EnumNames(AssetType{})) {
    fine[std::string(entry.name)] = FineSchema(catalogue.ValuesOf(entry.value));
  }
  const Json agent = ObjectSchema(
      {{"category", NamesSchema<AgentCategory>()},
       {"quantity", {{"type", "integer"}, {"minimum", 1}, {"maximum", kMaxGroupQuantity}}},
       {"state", NamesSchema<AgentState>()},
       {"position", NamesSchema<Region>()}});
  Json schema;
  schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  schema["title"] = "LatticeWorld environment configuration";
  schema["description"] = RuleDescription();
  schema.update(
      ObjectSchema({{"coarse", ObjectSchema({{"terrain_type", NamesSchema<TerrainType>()},
                                             {"season", NamesSchema<Season>()},
                                             {"artistic_style", NamesSchema<ArtisticStyle>()},
                                             {"weather", NamesSchema<Weather>()},
                                             {"time_of_day", NamesSchema<TimeOfDay>()}})},
                    {"fine", ObjectSchema(fine)},
                    {"agents", {{"type", "array"}, {"items", agent}}}}));
  return schema.dump(2) + "\n";
}

std::string EnvironmentSchema() { return EnvironmentSchema(*Catalogue::BuiltIn()); }

}  // namespace latticeworld
