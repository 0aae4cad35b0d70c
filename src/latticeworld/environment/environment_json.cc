// The JSON of y_C, in and out.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/environment_config.h"

namespace latticeworld {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxJsonBytes = 1 << 20;
constexpr int kMaxDepth = 8;
constexpr std::size_t kMaxKeys = 64;         // in one object; the largest legal one has eleven
constexpr std::size_t kMaxViolations = 500;  // what a person or a program can still use

// A key as a JSON pointer writes it (RFC 6901); what is too long for a message is cut.
std::string PointerToken(const std::string& key) {
  const std::string quoted = Quote(key);  // with quotation marks around it
  std::string token;
  for (const char c : quoted.substr(1, quoted.size() - 2)) {
    if (c == '~') {
      token += "~0";
    } else if (c == '/') {
      token += "~1";
    } else {
      token += c;
    }
  }
  return token;
}

// Follows the parser through a document and notes what the parsed value no longer shows: keys that
// stand twice in one object, and nesting deeper than any legal document has.
class ParseObserver {
 public:
  explicit ParseObserver(std::vector<Violation>* violations) : violations_(violations) {}

  int deepest() const { return deepest_; }

  // Whether to keep what was parsed. `depth` counts the containers that enclose the event; end
  // events do not come for what was not kept, so the path is cut to it instead of popped.
  bool Note(int depth, Json::parse_event_t event, const Json& parsed) {
    deepest_ = std::max(deepest_, depth);
    const auto level = static_cast<std::size_t>(depth);
    switch (event) {
      case Json::parse_event_t::object_start:
      case Json::parse_event_t::array_start:
        path_.resize(level);
        CountElement();
        path_.push_back({event == Json::parse_event_t::array_start, -1, "", {}});
        return true;
      case Json::parse_event_t::value:
        path_.resize(level);
        CountElement();
        return true;
      case Json::parse_event_t::key:
        path_.resize(level);
        return NoteKey(parsed.get<std::string>());
      default:
        return true;
    }
  }

 private:
  struct Container {
    bool is_array;
    int index;                   // of an array's latest element
    std::string key;             // of an object's latest member
    std::set<std::string> keys;  // of an object so far
  };

  void CountElement() {
    if (!path_.empty() && path_.back().is_array) ++path_.back().index;
  }

  bool NoteKey(std::string key) {
    Container& object = path_.back();
    object.key = std::move(key);
    // Deeper than legal, the document is refused for that; paths that long would fill the memory.
    const bool legal_depth = path_.size() <= static_cast<std::size_t>(kMaxDepth);
    if (!object.keys.insert(object.key).second && legal_depth) {
      violations_->push_back({"duplicate_key", Pointer(),
                              "the key " + Quote(object.key) + " stands twice in one object",
                              Quote(object.key)});
    }
    // ordered_json looks through all members at each new one: without a limit, a hostile
    // document would cost quadratic time. The keys within it are enough to show what is wrong.
    return object.keys.size() <= kMaxKeys;
  }

  std::string Pointer() const {
    std::string pointer;
    for (const Container& container : path_) {
      pointer += "/";
      pointer += container.is_array ? std::to_string(container.index) : PointerToken(container.key);
    }
    return pointer;
  }

  std::vector<Violation>* violations_;
  std::vector<Container> path_;  // from the outermost container inwards
  int deepest_ = 0;
};

// nlohmann's parser is iterative, so depth costs no stack; the limit keeps errors readable.
Result<Json> ParseStrictly(std::string_view text, std::vector<Violation>* violations) {
  ParseObserver observer(violations);
  try {
    Json json = Json::parse(text.begin(), text.end(),
                            [&](int depth, Json::parse_event_t event, Json& parsed) {
                              return observer.Note(depth, event, parsed);
                            });
    if (observer.deepest() > kMaxDepth) {
      return InvalidArgument("environment JSON is nested deeper than " + std::to_string(kMaxDepth));
    }
    return json;
  } catch (const Json::exception& exception) {
    return Status(StatusCode::kInvalidArgument,
                  "environment is not JSON: " + Quote(exception.what(), 300),
                  {{"parse_error", "", Quote(exception.what(), 300), Quote(text)}});
  }
}

// Reads fields of one object, noting what is missing, unknown or of the wrong type.
class ObjectReader {
 public:
  ObjectReader(const Json& json, std::string pointer, std::vector<Violation>* violations)
      : json_(json), pointer_(std::move(pointer)), violations_(violations) {
    if (!json_.is_object()) Wrong(pointer_, "an object", json_);
  }
  ~ObjectReader() {
    if (!json_.is_object()) return;
    for (const auto& [key, value] : json_.items()) {
      if (known_.count(key) > 0) continue;
      std::vector<std::string> legal(known_.begin(), known_.end());
      violations_->push_back({"unknown_key", pointer_ + "/" + PointerToken(key),
                              Quote(key) + " is not one of " + Join(legal, ", "), Quote(key)});
    }
  }
  ObjectReader(const ObjectReader&) = delete;
  ObjectReader& operator=(const ObjectReader&) = delete;

  // nullptr, and a violation, when the key is missing.
  const Json* Find(const std::string& key) {
    known_.insert(key);
    if (!json_.is_object()) return nullptr;
    const auto found = json_.find(key);
    if (found != json_.end()) return &*found;
    violations_->push_back({"missing_key", pointer_ + "/" + key, "is missing", ""});
    return nullptr;
  }

  void Read(const std::string& key, std::string* value) {
    const Json* json = Find(key);
    if (json == nullptr) return;
    if (!json->is_string()) return Wrong(At(key), "a string", *json);
    *value = json->get<std::string>();
  }
  void Read(const std::string& key, double* value) {
    const Json* json = Find(key);
    if (json == nullptr) return;
    if (!json->is_number()) return Wrong(At(key), "a number", *json);
    *value = json->get<double>();
  }
  void Read(const std::string& key, int* value) {
    const Json* json = Find(key);
    if (json == nullptr) return;
    if (!json->is_number_integer()) return Wrong(At(key), "a whole number", *json);
    const double number = json->get<double>();  // any integer that JSON can hold
    *value = static_cast<int>(std::max(-1e9, std::min(1e9, number)));
  }
  template <typename Enum>
  void ReadName(const std::string& key, Enum* value) {
    std::string name;
    const Json* json = Find(key);
    if (json == nullptr) return;
    if (!json->is_string()) return Wrong(At(key), "a string", *json);
    name = json->get<std::string>();
    if (const auto found = FromName<Enum>(name)) {
      *value = *found;
    } else {
      violations_->push_back({"unknown_value", At(key),
                              Quote(name) + " is not one of " + LegalNames<Enum>(), Quote(name)});
    }
  }

  void Wrong(const std::string& pointer, const std::string& wanted, const Json& given) {
    violations_->push_back({"wrong_type", pointer,
                            "must be " + wanted + ", not " + std::string(given.type_name()),
                            Quote(given.dump())});
  }
  std::string At(const std::string& key) const { return pointer_ + "/" + key; }

 private:
  const Json& json_;
  std::string pointer_;
  std::vector<Violation>* violations_;
  std::set<std::string> known_;
};

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

void ReadFine(const Json& json, AssetType type, FineAttribute* fine,
              std::vector<Violation>* violations) {
  const AssetTypeValues& values = ValuesOf(type);
  ObjectReader reader(json, "/fine/" + std::string(NameOf(type)), violations);
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
  reader.Read("quantity", &group.quantity);
  reader.ReadName("state", &group.state);
  reader.ReadName("position", &group.position);
  return group;
}

}  // namespace

Result<EnvironmentConfig> ParseEnvironment(std::string_view text) {
  LW_RETURN_IF_ERROR(ValidateText("environment JSON", text, kMaxJsonBytes));
  std::vector<Violation> violations;
  LW_ASSIGN_OR_RETURN(const Json json, ParseStrictly(text, &violations));

  EnvironmentConfig environment;
  {
    ObjectReader reader(json, "", &violations);
    if (const Json* coarse = reader.Find("coarse")) {
      ReadCoarse(*coarse, &environment.coarse, &violations);
    }
    if (const Json* fine = reader.Find("fine")) {
      ObjectReader fine_reader(*fine, "/fine", &violations);
      for (const auto& entry : EnumNames(AssetType{})) {
        if (const Json* one = fine_reader.Find(std::string(entry.name))) {
          ReadFine(*one, entry.value, &environment.fine_of(entry.value), &violations);
        }
      }
    }
    if (const Json* agents = reader.Find("agents")) {
      if (!agents->is_array()) reader.Wrong("/agents", "an array", *agents);
      // More groups than agents are legal cannot all be legal: reading them would tell nothing new.
      for (std::size_t i = 0; agents->is_array() && i < agents->size() && i <= kMaxAgents; ++i) {
        environment.agents.push_back(ReadAgentGroup((*agents)[i], i, &violations));
      }
    }
  }
  // Where the shape is wrong, the values that were not read would only be reported twice.
  if (violations.empty()) violations = Validate(environment);
  if (violations.size() > kMaxViolations) {
    const std::size_t further = violations.size() - kMaxViolations;
    violations.resize(kMaxViolations);
    violations.push_back(
        {"more_violations", "", "and " + std::to_string(further) + " further violations", ""});
  }
  if (!violations.empty()) {
    return Status::FromViolations("illegal environment", std::move(violations));
  }
  return environment;
}

std::string ToJson(const EnvironmentConfig& environment) {
  Json json;
  const CoarseAttributes& coarse = environment.coarse;
  json["coarse"] = {{"terrain_type", NameOf(coarse.terrain_type)},
                    {"season", NameOf(coarse.season)},
                    {"artistic_style", NameOf(coarse.artistic_style)},
                    {"weather", NameOf(coarse.weather)},
                    {"time_of_day", NameOf(coarse.time_of_day)}};
  for (const auto& entry : EnumNames(AssetType{})) {
    const FineAttribute& fine = environment.fine_of(entry.value);
    const AssetTypeValues& values = ValuesOf(entry.value);
    Json& one = json["fine"][std::string(entry.name)];
    one["season_variant"] = fine.season_variant;
    one["material"] = fine.material;
    one["density"] = fine.density;
    if (values.has_rotation) one["rotation"] = fine.rotation_deg;
    if (values.has_scale) one["scale"] = fine.scale;
    if (values.has_height) one["height"] = fine.height_m;
    if (values.has_wind) one["wind"] = fine.wind_mps;
    if (values.has_slope) one["slope"] = fine.slope_deg;
  }
  json["agents"] = Json::array();
  for (const AgentGroup& group : environment.agents) {
    json["agents"].push_back({{"category", NameOf(group.category)},
                              {"quantity", group.quantity},
                              {"state", NameOf(group.state)},
                              {"position", NameOf(group.position)}});
  }
  return json.dump(2) + "\n";
}

}  // namespace latticeworld
