#include "latticeworld/episode/journal_json.h"

#include <cmath>
#include <limits>
#include <utility>

#include "latticeworld/generation/json_fields.h"

namespace latticeworld {
namespace {

namespace jf = json_fields;
using jf::Json;

constexpr std::size_t kMaxCallBytes = 1u << 20;
constexpr int kMostTeam = 255;  // what is legal, the simulator says

std::string Line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

template <typename T>
Json OrNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}
template <typename Enum>
Json NameOrNull(const std::optional<Enum>& value) {
  return value ? Json(NameOf(*value)) : Json();
}
Json OrNull(double value) { return std::isfinite(value) ? Json(value) : Json(); }

bool IsNull(const Json& object, const char* key) { return jf::Member(object, key).is_null(); }

std::optional<double> OptionalNumber(const Json& json, const char* key) {
  if (IsNull(json, key)) return std::nullopt;
  return jf::Number(json, key);
}
double NumberOrNan(const Json& json, const char* key) {
  return OptionalNumber(json, key).value_or(std::numeric_limits<double>::quiet_NaN());
}
template <typename Enum>
std::optional<Enum> OptionalNamed(const Json& json, const char* key) {
  if (IsNull(json, key)) return std::nullopt;
  return jf::Named<Enum>(json, key);
}
std::optional<int> OptionalTeam(const Json& json, const char* key) {
  if (IsNull(json, key)) return std::nullopt;
  return static_cast<int>(jf::Integer(json, key, 0, kMostTeam));
}

// The numbers of an array of that many.
std::vector<double> Numbers(const Json& json, const char* key, std::size_t count) {
  std::vector<double> numbers;
  for (const Json& value : jf::Array(json, key)) {
    if (!value.is_number()) jf::Fail(key, value, "a number");
    numbers.push_back(value.get<double>());
  }
  if (numbers.size() != count) {
    jf::Fail(key, jf::Member(json, key), std::to_string(count) + " numbers");
  }
  return numbers;
}

// One overload a call; each begins with its name.
Json ToJson(const CommandCall& it) {
  const Eigen::Vector3d& linear_mps = it.command.linear_mps;
  return {{"call", "command"},
          {"agent", it.agent},
          {"linear_mps", {linear_mps.x(), linear_mps.y(), linear_mps.z()}},
          {"yaw_rate_radps", it.command.yaw_rate_radps}};
}
Json ToJson(const CommandJointsCall& it) {
  Json joints = Json::array();
  for (const JointCommand& joint : it.commands) {
    joints.push_back({{"joint", joint.joint},
                      {"position_rad", OrNull(joint.position_rad)},
                      {"velocity_radps", OrNull(joint.velocity_radps)},
                      {"effort_nm", OrNull(joint.effort_nm)}});
  }
  return {{"call", "command_joints"}, {"agent", it.agent}, {"joints", std::move(joints)}};
}
Json ToJson(const StrikeCall& it) { return {{"call", "strike"}, {"agent", it.agent}}; }
Json ToJson(const SetPolicyCall& it) {
  return {{"call", "set_policy"},
          {"agent", it.change.agent},
          {"team", OrNull(it.change.team)},
          {"policy", it.change.policy}};
}
Json ToJson(const SpawnCall& it) {
  const SpawnRequest& request = it.request;
  Json position;
  if (request.position) position = {request.position->x_m, request.position->y_m};
  return {{"call", "spawn"},
          {"name", request.name},
          {"category", NameOf(request.category)},
          {"species", request.species},
          {"state", NameOrNull(request.state)},
          {"position_m", std::move(position)},
          {"region", NameOf(request.region)},
          {"heading_rad", request.heading_rad},
          {"controllable", request.controllable},
          {"team", OrNull(request.team)},
          {"policy", request.policy},
          {"answer", it.answer}};
}
Json ToJson(const RemoveCall& it) { return {{"call", "remove"}, {"agent", it.agent}}; }
Json ToJson(const SpawnPropCall& it) {
  const Prop& prop = it.prop;
  return {
      {"call", "spawn_element"},   {"name", prop.name},
      {"kind", NameOf(prop.kind)}, {"position_m", {prop.position.x_m, prop.position.y_m, prop.z_m}},
      {"yaw_rad", prop.yaw_rad},   {"size_m", {prop.size_m.x(), prop.size_m.y(), prop.size_m.z()}},
      {"mass_kg", prop.mass_kg},   {"strength", prop.strength},
      {"answer", it.answer}};
}
Json ToJson(const RemovePropCall& it) { return {{"call", "remove_element"}, {"element", it.prop}}; }
Json ToJson(const OpenGateCall& it) {
  return {{"call", "open_gate"}, {"element", it.prop}, {"opening_rad", it.opening_rad}};
}
Json ToJson(const SetWeatherCall& it) {
  const WeatherChange& change = it.change;
  return {{"call", "set_weather"},
          {"weather", NameOrNull(change.weather)},
          {"intensity", OrNull(change.intensity)},
          {"wind_speed_mps", OrNull(change.wind_speed_mps)},
          {"wind_heading_rad", OrNull(change.wind_heading_rad)},
          {"gust_mps", OrNull(change.gust_mps)},
          {"visibility_m", OrNull(change.visibility_m)},
          {"ground_wetness", OrNull(change.ground_wetness)},
          {"snow_depth_m", OrNull(change.snow_depth_m)},
          {"water_rise_m", OrNull(change.water_rise_m)},
          {"hour", OrNull(change.hour)},
          {"transition_s", change.transition_s}};
}
Json ToJson(const ResetCall& it) { return {{"call", "reset"}, {"seed", it.seed}}; }
Json ToJson(const SaveCall& it) { return {{"call", "save"}, {"snapshot", it.snapshot}}; }
Json ToJson(const RestoreCall& it) { return {{"call", "restore"}, {"snapshot", it.snapshot}}; }

CommandCall ToCommand(const Json& json) {
  jf::ExpectKeys(json, {"call", "agent", "linear_mps", "yaw_rate_radps"});
  const std::vector<double> linear_mps = Numbers(json, "linear_mps", 3);
  CommandCall it;
  it.agent = jf::Text(json, "agent");
  it.command.linear_mps = {linear_mps[0], linear_mps[1], linear_mps[2]};
  it.command.yaw_rate_radps = jf::Number(json, "yaw_rate_radps");
  return it;
}

CommandJointsCall ToCommandJoints(const Json& json) {
  jf::ExpectKeys(json, {"call", "agent", "joints"});
  CommandJointsCall it;
  it.agent = jf::Text(json, "agent");
  for (const Json& joint : jf::Array(json, "joints")) {
    jf::ExpectKeys(joint, {"joint", "position_rad", "velocity_radps", "effort_nm"});
    it.commands.push_back({jf::Text(joint, "joint"), NumberOrNan(joint, "position_rad"),
                           NumberOrNan(joint, "velocity_radps"), NumberOrNan(joint, "effort_nm")});
  }
  return it;
}

SetPolicyCall ToSetPolicy(const Json& json) {
  jf::ExpectKeys(json, {"call", "agent", "team", "policy"});
  return {{jf::Text(json, "agent"), OptionalTeam(json, "team"), jf::Text(json, "policy")}};
}

SpawnCall ToSpawn(const Json& json) {
  jf::ExpectKeys(json, {"call", "name", "category", "species", "state", "position_m", "region",
                        "heading_rad", "controllable", "team", "policy", "answer"});
  SpawnCall it;
  it.request.name = jf::Text(json, "name");
  it.request.category = jf::Named<AgentCategory>(json, "category");
  it.request.species = jf::Text(json, "species");
  it.request.state = OptionalNamed<AgentState>(json, "state");
  if (!IsNull(json, "position_m")) {
    const std::vector<double> position_m = Numbers(json, "position_m", 2);
    it.request.position = WorldPoint{position_m[0], position_m[1]};
  }
  it.request.region = jf::Named<Region>(json, "region");
  it.request.heading_rad = jf::Number(json, "heading_rad");
  it.request.controllable = jf::Boolean(json, "controllable");
  it.request.team = OptionalTeam(json, "team");
  it.request.policy = jf::Text(json, "policy");
  it.answer = jf::Text(json, "answer");
  return it;
}

SpawnPropCall ToSpawnProp(const Json& json) {
  jf::ExpectKeys(json, {"call", "name", "kind", "position_m", "yaw_rad", "size_m", "mass_kg",
                        "strength", "answer"});
  const std::vector<double> position_m = Numbers(json, "position_m", 3);
  const std::vector<double> size_m = Numbers(json, "size_m", 3);
  SpawnPropCall it;
  it.prop.name = jf::Text(json, "name");
  it.prop.kind = jf::Named<PropKind>(json, "kind");
  it.prop.position = {position_m[0], position_m[1]};
  it.prop.z_m = position_m[2];
  it.prop.yaw_rad = jf::Number(json, "yaw_rad");
  it.prop.size_m = {size_m[0], size_m[1], size_m[2]};
  it.prop.mass_kg = jf::Number(json, "mass_kg");
  it.prop.strength = jf::Number(json, "strength");
  it.answer = jf::Text(json, "answer");
  return it;
}

SetWeatherCall ToSetWeather(const Json& json) {
  jf::ExpectKeys(json, {"call", "weather", "intensity", "wind_speed_mps", "wind_heading_rad",
                        "gust_mps", "visibility_m", "ground_wetness", "snow_depth_m",
                        "water_rise_m", "hour", "transition_s"});
  SetWeatherCall it;
  it.change.weather = OptionalNamed<Weather>(json, "weather");
  it.change.intensity = OptionalNumber(json, "intensity");
  it.change.wind_speed_mps = OptionalNumber(json, "wind_speed_mps");
  it.change.wind_heading_rad = OptionalNumber(json, "wind_heading_rad");
  it.change.gust_mps = OptionalNumber(json, "gust_mps");
  it.change.visibility_m = OptionalNumber(json, "visibility_m");
  it.change.ground_wetness = OptionalNumber(json, "ground_wetness");
  it.change.snow_depth_m = OptionalNumber(json, "snow_depth_m");
  it.change.water_rise_m = OptionalNumber(json, "water_rise_m");
  it.change.hour = OptionalNumber(json, "hour");
  it.change.transition_s = jf::Number(json, "transition_s");
  return it;
}

// Reads the argument of a call that has one text.
std::string OnlyText(const Json& json, const char* key) {
  jf::ExpectKeys(json, {"call", key});
  return jf::Text(json, key);
}
std::uint64_t OnlyUnsigned(const Json& json, const char* key) {
  jf::ExpectKeys(json, {"call", key});
  return jf::Unsigned(json, key);
}

JournalCall Decode(std::string_view text) {
  if (text.size() > kMaxCallBytes) {
    throw jf::FieldError("is " + std::to_string(text.size()) + " bytes long; at most " +
                         std::to_string(kMaxCallBytes) + " are legal");
  }
  const Json json = jf::Parse(text);
  if (!json.is_object() || !json.contains("call")) {
    throw jf::FieldError(jf::Shown(json) + " is no object with a key call");
  }
  const std::string name = jf::Text(json, "call");
  if (name == "command") return ToCommand(json);
  if (name == "command_joints") return ToCommandJoints(json);
  if (name == "strike") return StrikeCall{OnlyText(json, "agent")};
  if (name == "set_policy") return ToSetPolicy(json);
  if (name == "spawn") return ToSpawn(json);
  if (name == "remove") return RemoveCall{OnlyText(json, "agent")};
  if (name == "spawn_element") return ToSpawnProp(json);
  if (name == "remove_element") return RemovePropCall{OnlyText(json, "element")};
  if (name == "set_weather") return ToSetWeather(json);
  if (name == "reset") return ResetCall{OnlyUnsigned(json, "seed")};
  if (name == "save") return SaveCall{OnlyUnsigned(json, "snapshot")};
  if (name == "restore") return RestoreCall{OnlyUnsigned(json, "snapshot")};
  if (name == "open_gate") {
    jf::ExpectKeys(json, {"call", "element", "opening_rad"});
    return OpenGateCall{jf::Text(json, "element"), jf::Number(json, "opening_rad")};
  }
  jf::Fail("call", json["call"],
           "one of command, command_joints, strike, set_policy, spawn, remove, spawn_element, "
           "remove_element, open_gate, set_weather, reset, save, restore");
}

SimulatorOptions DecodeAllOf(std::string_view text) {
  const Json json = jf::Parse(text);
  jf::ExpectKeys(json, {"step_s", "command_timeout_s", "pursuit_distance_m", "day_length_s",
                        "robot_species", "species"});
  SimulatorOptions options;
  options.step_s = jf::Number(json, "step_s");
  options.command_timeout_s = jf::Number(json, "command_timeout_s");
  options.pursuit_distance_m = jf::Number(json, "pursuit_distance_m");
  options.day_length_s = jf::Number(json, "day_length_s");
  options.robot_species = jf::Text(json, "robot_species");
  std::vector<std::pair<std::string, std::string>> files;
  for (const Json& file : jf::Array(json, "species")) {
    jf::ExpectKeys(file, {"name", "text"});
    files.emplace_back(jf::Text(file, "name"), jf::Text(file, "text"));
  }
  if (!files.empty()) {
    auto species = SpeciesCatalogue::Extended(files);
    if (!species.ok()) throw jf::FieldError(species.status().message());
    options.species = *std::move(species);
  }
  const Status legal = Status::FromViolations("options", Validate(options));
  if (!legal.ok()) throw jf::FieldError(legal.message());
  return options;
}

}  // namespace

std::string EncodeCall(const JournalCall& call) {
  return Line(std::visit([](const auto& it) { return ToJson(it); }, call));
}

Result<JournalCall> DecodeCall(std::string_view json) {
  try {
    return Decode(json);
  } catch (const std::exception& error) {  // FieldError and nlohmann's
    return DataLoss("a recorded call: " + std::string(error.what()));
  }
}

std::string EncodeSimulatorOptions(const SimulatorOptions& options) {
  Json species = Json::array();
  for (const auto& [name, text] : options.species->added_files()) {
    species.push_back({{"name", name}, {"text", text}});
  }
  return Line({{"step_s", options.step_s},
               {"command_timeout_s", options.command_timeout_s},
               {"pursuit_distance_m", options.pursuit_distance_m},
               {"day_length_s", options.day_length_s},
               {"robot_species", options.robot_species},
               {"species", std::move(species)}});
}

Result<SimulatorOptions> DecodeSimulatorOptions(std::string_view json) {
  try {
    return DecodeAllOf(json);
  } catch (const std::exception& error) {  // FieldError and nlohmann's
    return DataLoss("the recorded options: " + std::string(error.what()));
  }
}

}  // namespace latticeworld
