// The JSON of y_C, in and out.

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/strict_json.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/environment/object_reader.h"

namespace latticeworld {
namespace {

using Json = nlohmann::json;

void ReadCoarse(const Json& json, CoarseAttributes* coarse, std::vector<Violation>* violations) {
  ObjectReader reader(json, "/coarse", violations);
  reader.ReadName("terrain_type", &coarse->terrain_type);
  reader.ReadName("season", &coarse->season);
  reader.ReadName("artistic_style", &coarse->artistic_style);
  reader.ReadName("weather", &coarse->weather);
  reader.ReadName("time_of_day", &coarse->time_of_day);
}

void ReadRotation(ObjectReader* reader, FineAttribute* fine) {
  const Json* json = reader->Find("rotation");
  if (json == nullptr) return;
  if (!json->is_array() || json->size() != 3) {
    return reader->Wrong(reader->At("rotation"), "an array [roll, pitch, yaw] of three degrees",
                         *json);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if ((*json)[i].is_number()) {
      fine->rotation_deg[i] = (*json)[i].get<double>();
    } else {
      reader->Wrong(reader->At("rotation") + "/" + std::to_string(i), "a number", (*json)[i]);
    }
  }
}

void ReadFine(const Json& json, const AssetTypeValues& values, FineAttribute* fine,
              std::vector<Violation>* violations) {
  ObjectReader reader(json, "/fine/" + std::string(NameOf(values.type)), violations);
  reader.Read("season_variant", &fine->season_variant);
  reader.Read("material", &fine->material);
  reader.Read("density", &fine->density);
  if (values.has_rotation) ReadRotation(&reader, fine);
  if (values.has_scale) reader.Read("scale", &fine->scale);
  if (values.has_height) reader.Read("height", &fine->height_m);
  if (values.has_wind) reader.Read("wind", &fine->wind_mps);
  if (values.has_slope) reader.Read("slope", &fine->slope_deg);
}

AgentGroup ReadAgentGroup(const Json& json, std::size_t index, std::vector<Violation>* violations) {
  AgentGroup group;
  ObjectReader reader(json, "/agents/" + std::to_string(index), violations);
  reader.ReadName("category", &group.category);
  reader.Read("quantity", 1, kMaxGroupQuantity, &group.quantity);
  reader.ReadName("state", &group.state);
  reader.ReadName("position", &group.position);
  return group;
}

void ReadAgents(const Json& json, std::vector<AgentGroup>* groups,
                std::vector<Violation>* violations) {
  if (!json.is_array()) {
    violations->push_back(WrongType("/agents", "an array", json));
  } else if (json.size() > kMaxAgents) {
    // A group is one agent at least: reading them would tell nothing new.
    const std::string most = std::to_string(kMaxAgents);
    violations->push_back(
        {"out_of_range", "/agents",
         "more than " + most + " groups; at most " + most + " agents in all are legal",
         "more than " + most});
  } else {
    for (std::size_t i = 0; i < json.size(); ++i) {
      groups->push_back(ReadAgentGroup(json[i], i, violations));
    }
  }
}

Status Illegal(std::vector<Violation> violations) {
  LimitViolations(&violations);
  return Status::FromViolations("illegal environment", std::move(violations));
}

}  // namespace

Result<EnvironmentConfig> ParseUncheckedEnvironment(std::string_view text,
                                                    const Catalogue& catalogue) {
  std::vector<Violation> violations;
  Json json;
  EnvironmentConfig environment;
  JsonLimits limits;
  limits.max_elements = kMaxAgents + 1;  // one more than is legal shows the fault
  if (ParseStrictly(text, "", limits, &json, &violations)) {
    ObjectReader reader(json, "", &violations);
    if (const Json* coarse = reader.Find("coarse")) {
      ReadCoarse(*coarse, &environment.coarse, &violations);
    }
    if (const Json* fine = reader.Find("fine")) {
      ObjectReader fine_reader(*fine, "/fine", &violations);
      for (const auto& entry : EnumNames(AssetType{})) {
        if (const Json* one = fine_reader.Find(std::string(entry.name))) {
          ReadFine(*one, catalogue.ValuesOf(entry.value), &environment.fine_of(entry.value),
                   &violations);
        }
      }
    }
    if (const Json* agents = reader.Find("agents")) {
      ReadAgents(*agents, &environment.agents, &violations);
    }
  }
  LW_RETURN_IF_ERROR(Illegal(std::move(violations)));
  return environment;
}

Result<EnvironmentConfig> ParseEnvironment(std::string_view text, const Catalogue& catalogue) {
  // If the shape is wrong, the values that were not read would only be reported twice.
  LW_ASSIGN_OR_RETURN(EnvironmentConfig environment, ParseUncheckedEnvironment(text, catalogue));
  LW_RETURN_IF_ERROR(Illegal(Validate(environment, catalogue)));
  return environment;
}

Result<EnvironmentConfig> ParseEnvironment(std::string_view text) {
  return ParseEnvironment(text, *Catalogue::BuiltIn());
}

std::string ToJson(const EnvironmentConfig& environment, const Catalogue& catalogue) {
  nlohmann::ordered_json json;
  const CoarseAttributes& coarse = environment.coarse;
  json["coarse"] = {{"terrain_type", NameOf(coarse.terrain_type)},
                    {"season", NameOf(coarse.season)},
                    {"artistic_style", NameOf(coarse.artistic_style)},
                    {"weather", NameOf(coarse.weather)},
                    {"time_of_day", NameOf(coarse.time_of_day)}};
  for (const auto& entry : EnumNames(AssetType{})) {
    const FineAttribute& fine = environment.fine_of(entry.value);
    const AssetTypeValues& values = catalogue.ValuesOf(entry.value);
    nlohmann::ordered_json& one = json["fine"][std::string(entry.name)];
    one["season_variant"] = fine.season_variant;
    one["material"] = fine.material;
    one["density"] = fine.density;
    if (values.has_rotation) one["rotation"] = fine.rotation_deg;
    if (values.has_scale) one["scale"] = fine.scale;
    if (values.has_height) one["height"] = fine.height_m;
    if (values.has_wind) one["wind"] = fine.wind_mps;
    if (values.has_slope) one["slope"] = fine.slope_deg;
  }
  json["agents"] = nlohmann::ordered_json::array();
  for (const AgentGroup& group : environment.agents) {
    json["agents"].push_back({{"category", NameOf(group.category)},
                              {"quantity", group.quantity},
                              {"state", NameOf(group.state)},
                              {"position", NameOf(group.position)}});
  }
  return json.dump(2) + "\n";
}

std::string ToJson(const EnvironmentConfig& environment) {
  return ToJson(environment, *Catalogue::BuiltIn());
}

}  // namespace latticeworld
