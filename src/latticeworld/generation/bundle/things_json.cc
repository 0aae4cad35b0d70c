#include "latticeworld/generation/bundle/things_json.h"

#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/generation/json_fields.h"
#include "latticeworld/generation/ros_name.h"
#include "latticeworld/language/class_words.h"
#include "latticeworld/language/tokens.h"
#include "latticeworld/layout/thing_kinds.h"
#include "latticeworld/layout/thing_wishes.h"

namespace latticeworld {
namespace {

namespace jf = json_fields;
using jf::Json;

constexpr std::size_t kMostBytes = 1u << 20;
constexpr double kFarthest_m = 80.0;
constexpr double kMostYaw_rad = 1000.0;

// Reads the wishes one by one and finds every fault on the way.
class ThingReader {
 public:
  ThingReader(const Catalogue& catalogue, Vocabulary vocabulary)
      : catalogue_(catalogue), vocabulary_(vocabulary) {}

  Result<std::vector<ThingWish>> Read(const Json& json) {
    if (!json.is_array()) {
      Fault("", "wrong_type", "is no array of objects", jf::Shown(json));
    } else if (json.size() > static_cast<std::size_t>(kMostThingWishes)) {
      Fault("", "wrong_count",
            "has " + std::to_string(json.size()) + " entries; legal are at most " +
                std::to_string(kMostThingWishes),
            std::to_string(json.size()));
    } else {
      for (std::size_t i = 0; i < json.size(); ++i) ReadWish(json[i], i);
    }
    if (!violations_.empty()) return Status::FromViolations("unusable things", violations_);
    return std::move(wishes_);
  }

 private:
  void Fault(const std::string& key, const char* code, const std::string& message,
             const std::string& given) {
    violations_.push_back({code, "things" + at_ + (key.empty() ? "" : "/" + key), message, given});
  }

  void ReadWish(const Json& json, std::size_t index) {
    at_ = "/" + std::to_string(index);
    ThingWish wish;
    if (!json.is_object()) {
      Fault("", "wrong_type", "is no object", jf::Shown(json));
      wishes_.push_back(wish);
      return;
    }
    static const std::set<std::string> kKeys = {
        "kind", "name",  "x",        "y",  "yaw_deg",    "count", "arrangement", "spacing_m",
        "size", "place", "relation", "of", "distance_m", "side",  "and",         "facing"};
    for (const auto& item : json.items()) {
      if (kKeys.count(item.key()) > 0) continue;
      Fault(item.key(), "unknown_key",
            "is unknown; legal are " + Join({kKeys.begin(), kKeys.end()}, ", "), Quote(item.key()));
    }
    ReadKind(json, &wish);
    ReadName(json, index, &wish);
    ReadPlace(json, &wish);
    ReadArrangement(json, &wish);
    ReadRelation(json, &wish);
    wish.words = wish.name.empty() ? wish.kind : wish.name;
    wishes_.push_back(std::move(wish));
  }

  std::optional<std::string> Text(const Json& json, const char* key) {
    if (!json.contains(key)) return std::nullopt;
    if (json.at(key).is_string()) return json.at(key).get<std::string>();
    Fault(key, "wrong_type", "is " + jf::Shown(json.at(key)) + ", not a text",
          jf::Shown(json.at(key)));
    return std::nullopt;
  }
  std::optional<double> Number(const Json& json, const char* key, double low, double high) {
    if (!json.contains(key)) return std::nullopt;
    const Json& value = json.at(key);
    if (value.is_number() && value.get<double>() >= low && value.get<double>() <= high) {
      return value.get<double>();
    }
    Fault(key, "out_of_range",
          "is " + jf::Shown(value) + ", not a number from " + FormatDouble(low) + " to " +
              FormatDouble(high),
          jf::Shown(value));
    return std::nullopt;
  }
  template <typename Enum>
  void Name(const Json& json, const char* key, Enum* value) {
    const std::optional<std::string> name = Text(json, key);
    if (!name) return;
    if (const auto known = FromName<Enum>(*name)) {
      *value = *known;
    } else {
      Fault(key, "unknown_value", "is " + Quote(*name) + "; legal are " + LegalNames<Enum>(),
            *name);
    }
  }

  void ReadKind(const Json& json, ThingWish* wish) {
    const std::optional<std::string> kind = Text(json, "kind");
    if (!json.contains("kind")) Fault("kind", "missing_key", "is missing", "");
    if (!kind) return;
    // In words a bridge is one of a road.
    if (const ThingKind* known = FindThingKind(*kind == "bridge" ? "footbridge" : *kind)) {
      wish->kind = known->name;
      return;
    }
    wish->kind = *kind;
    for (const AssetModel& model : catalogue_.models()) {
      if (model.name == *kind) return;
    }
    Fault("kind", "unknown_value",
          "is " + Quote(*kind) + "; the nearest is " + NearestThingKind(*kind) + ", legal are " +
              LegalThingKinds() + ", and the models of the catalogue",
          *kind);
  }

  void ReadName(const Json& json, std::size_t index, ThingWish* wish) {
    const std::optional<std::string> name = Text(json, "name");
    if (!name) return;
    constexpr std::size_t kLongest = 64;
    if (!IsRosName(*name) || name->size() > kLongest) {
      Fault("name", "bad_format",
            "is " + Quote(*name) + ", not a letter followed by letters, digits and underscores, " +
                std::to_string(kLongest) + " at most",
            *name);
    } else if (!index_of_.emplace(*name, static_cast<int>(index)).second) {
      Fault("name", "duplicate_name", Quote(*name) + " is another thing's already", *name);
    }
    wish->name = *name;
  }

  void ReadPlace(const Json& json, ThingWish* wish) {
    constexpr double kWorld_m = 4096.0;  // half of the largest
    const std::optional<double> x = Number(json, "x", -kWorld_m, kWorld_m);
    const std::optional<double> y = Number(json, "y", -kWorld_m, kWorld_m);
    if (json.contains("x") != json.contains("y")) {
      Fault(json.contains("x") ? "y" : "x", "missing_key", "is missing; x and y go together", "");
    }
    if (x && y) wish->position = WorldPoint{*x, *y};
    if (const auto yaw_deg = Number(json, "yaw_deg", -360.0, 360.0)) {
      wish->heading_rad = *yaw_deg * M_PI / 180.0;
    }
    if (const auto place = Text(json, "place")) {
      if (const auto zone = FindZone(*place)) {
        wish->zone = *zone;
      } else {
        std::vector<std::string> names;
        for (const std::string_view name : ZoneNames()) names.emplace_back(name);
        Fault("place", "unknown_value", "is " + Quote(*place) + "; legal are " + Join(names, ", "),
              *place);
      }
    }
  }

  void ReadArrangement(const Json& json, ThingWish* wish) {
    if (const auto count = Number(json, "count", 1.0, kMostThings)) {
      if (*count != std::floor(*count)) {
        Fault("count", "wrong_type", "is no whole number", FormatDouble(*count));
      }
      wish->count = wish->count_least = wish->count_most = static_cast<int>(*count);
    }
    Name(json, "arrangement", &wish->arrangement);
    wish->spacing_m = Number(json, "spacing_m", 0.1, 500.0).value_or(0.0);
    wish->size = Number(json, "size", 0.2, 5.0).value_or(1.0);
    if (wish->position && wish->count > 1 && wish->arrangement == ThingArrangement::kNone) {
      Fault("arrangement", "missing_key", "is missing; several things have one at an exact place",
            "");
    }
  }

  void ReadRelation(const Json& json, ThingWish* wish) {
    Name(json, "relation", &wish->relation);
    Name(json, "side", &wish->side);
    ReadTarget(json, "of", &wish->target);
    ReadTarget(json, "facing", &wish->facing);
    wish->distance_m = Number(json, "distance_m", 0.1, kFarthest_m).value_or(0.0);
    if (!json.contains("count")) FillRun(wish);
    const bool relates = wish->relation != ThingRelation::kNone;
    const bool between = wish->relation == ThingRelation::kBetween;
    ReadTarget(json, "and", &wish->second);
    if (between && !json.contains("and")) Fault("and", "missing_key", "is missing", "");
    if (!between && json.contains("and")) {
      Fault("and", "conflict", "is given with another relation than between", "");
    }
    if (relates && !json.contains("of")) Fault("of", "missing_key", "is missing", "");
    if (!relates && json.contains("of")) {
      Fault("relation", "missing_key", "is missing; of has one", "");
    }
    if (wish->side != ThingSide::kAny && wish->relation != ThingRelation::kNear) {
      Fault("side", "conflict", "is given with another relation than near", "");
    }
    if (relates && wish->position) {
      Fault("relation", "conflict", "is given with an exact place; legal is one of the two", "");
    }
  }

  void ReadTarget(const Json& json, const char* key, ThingTarget* target) {
    const std::optional<std::string> name = Text(json, key);
    if (!name) return;
    const auto known = index_of_.find(*name);
    if (known != index_of_.end() && known->second < static_cast<int>(wishes_.size())) {
      target->wish = known->second;
      return;
    }
    target->letter = GroundNamed(*name);
    if (!target->is_nothing()) return;
    const std::vector<Token> tokens = Tokenize(*name);
    const ClassWordMatch match = tokens.empty() ? ClassWordMatch() : MatchClassWord(tokens, 0);
    if (match.word != nullptr && match.tokens == tokens.size()) {
      target->letter = match.word->LetterIn(vocabulary_);
    }
    if (!target->is_nothing()) return;
    Fault(key, "unknown_value",
          "is " + Quote(*name) + "; legal are the name of a thing before this one and nouns of " +
              std::string(NameOf(vocabulary_)) + " land such as forest, water",
          *name);
  }

  const Catalogue& catalogue_;
  const Vocabulary vocabulary_;
  std::string at_;
  std::vector<ThingWish> wishes_;
  std::map<std::string, int> index_of_;
  std::vector<Violation> violations_;
};

Json Encode(const SceneThing& thing) {
  return {{"name", thing.name},      {"kind", thing.kind},        {"wish", thing.wish},
          {"asset", thing.asset},    {"x_m", thing.position.x_m}, {"y_m", thing.position.y_m},
          {"yaw_rad", thing.yaw_rad}};
}

SceneThing Decode(const Json& json, const GridGeometry& geometry, std::size_t assets) {
  jf::ExpectKeys(json, {"name", "kind", "wish", "asset", "x_m", "y_m", "yaw_rad"});
  SceneThing thing;
  thing.name = jf::Text(json, "name");
  if (!IsRosName(thing.name)) {
    jf::Fail("name", json["name"], "a letter followed by letters, digits and underscores");
  }
  thing.kind = jf::Text(json, "kind");
  thing.wish = static_cast<int>(jf::Integer(json, "wish", 0, 2 * kMostThingWishes));
  thing.asset = static_cast<std::int32_t>(
      jf::Integer(json, "asset", -1, static_cast<std::int64_t>(assets) - 1));
  const double half_m = geometry.half_size_m();
  thing.position = {jf::Number(json, "x_m", -half_m, half_m),
                    jf::Number(json, "y_m", -half_m, half_m)};
  thing.yaw_rad = jf::Number(json, "yaw_rad", -kMostYaw_rad, kMostYaw_rad);
  return thing;
}

}  // namespace

Result<std::vector<ThingWish>> ParseThings(std::string_view json, const Catalogue& catalogue,
                                           Vocabulary vocabulary) {
  if (json.empty()) return std::vector<ThingWish>();
  if (json.size() > kMostBytes) {
    return InvalidArgument("things: " + std::to_string(json.size()) + " bytes; legal are at most " +
                           std::to_string(kMostBytes));
  }
  try {
    return ThingReader(catalogue, vocabulary).Read(jf::Parse(json));
  } catch (const std::exception& error) {  // JSON
    return Status::FromViolations(
        "unusable things", {{"bad_format", "things", std::string("no JSON: ") + error.what(), ""}});
  }
}

std::string EncodeThings(const ThingsFile& file) {
  Json json = {{"request", file.request}, {"things", Json::array()}};
  for (const SceneThing& thing : file.things) json["things"].push_back(Encode(thing));
  return jf::Dump(json);
}

Result<ThingsFile> DecodeThings(std::string_view content, const GridGeometry& geometry,
                                std::size_t assets) {
  try {
    const Json json = jf::Parse(content);
    jf::ExpectKeys(json, {"request", "things"});
    ThingsFile file;
    file.request = jf::Text(json, "request");
    std::set<std::string> names;
    for (const Json& entry : jf::Array(json, "things")) {
      file.things.push_back(Decode(entry, geometry, assets));
      if (!names.insert(file.things.back().name).second) {
        jf::Fail("name", entry["name"], "a name that no thing before it has");
      }
    }
    return file;
  } catch (const std::exception& error) {  // JSON
    return DataLoss(error.what());
  }
}

Result<std::vector<ThingWish>> WishedThings(std::string_view json, const LayoutPlan& plan,
                                            const Catalogue& catalogue, Vocabulary vocabulary) {
  LW_ASSIGN_OR_RETURN(std::vector<ThingWish> things, ParseThings(json, catalogue, vocabulary));
  AppendWishes(plan.things, &things);
  return things;
}

}  // namespace latticeworld
