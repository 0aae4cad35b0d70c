// data/coarse_to_fine.json -> rules.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/schema_check.h"
#include "latticeworld/common/strict_json.h"
#include "latticeworld/common/text.h"
#include "latticeworld/environment/rule_book.h"

namespace latticeworld {

std::string_view RuleFile(std::string_view file_name);  // compiled in

namespace {

using Json = nlohmann::json;

// Reads a document that obeys the schema.
class RuleReader {
 public:
  explicit RuleReader(std::vector<Violation>* violations) : violations_(violations) {}

  std::vector<Rule> Read(const Json& json) {
    std::vector<Rule> rules;
    const Json& list = json["rules"];
    for (std::size_t i = 0; i < list.size(); ++i) {
      rules.push_back(ReadRule(list[i], "/rules/" + std::to_string(i)));
    }
    return rules;
  }

 private:
  void Add(std::string code, std::string pointer, std::string message, std::string given) {
    violations_->push_back(
        {std::move(code), std::move(pointer), std::move(message), std::move(given)});
  }

  Rule ReadRule(const Json& json, const std::string& at) {
    Rule rule;
    rule.label = {json["id"].get<std::string>(), json["why"].get<std::string>()};
    if (!ids_.insert(rule.label.id).second) {
      Add("duplicate_name", at + "/id", "another rule is called " + Quote(rule.label.id) + " too",
          Quote(rule.label.id));
    }
    if (!json.contains("when")) {
      rule.when.emplace_back();
    } else {
      for (std::size_t i = 0; i < json["when"].size(); ++i) {
        rule.when.push_back(ReadCondition(json["when"][i], at + "/when/" + std::to_string(i)));
      }
    }
    for (std::size_t i = 0; i < json["then"].size(); ++i) {
      rule.then.push_back(ReadEffect(json["then"][i], at + "/then/" + std::to_string(i)));
    }
    return rule;
  }

  RuleCondition ReadCondition(const Json& json, const std::string& at) {
    RuleCondition condition;
    ReadSet<TerrainType>(json, "terrain_type", at, &condition.terrain_types);
    ReadSet<Season>(json, "season", at, &condition.seasons);
    ReadSet<Weather>(json, "weather", at, &condition.weathers);
    ReadSet<TimeOfDay>(json, "time_of_day", at, &condition.times_of_day);
    return condition;
  }

  template <typename Enum>
  void ReadSet(const Json& json, const char* key, const std::string& at, std::uint32_t* set) {
    if (!json.contains(key)) return;
    *set = 0;
    for (const Enum value : ReadNames<Enum>(json[key], at + "/" + key)) {
      *set |= 1u << static_cast<unsigned>(value);
    }
  }

  template <typename Enum>
  std::vector<Enum> ReadNames(const Json& json, const std::string& at) {
    std::vector<Enum> values;
    for (std::size_t i = 0; i < json.size(); ++i) {
      const auto name = json[i].get<std::string>();
      if (const auto value = FromName<Enum>(name)) {
        values.push_back(*value);
      } else {
        Add("unknown_value", at + "/" + std::to_string(i),
            Quote(name) + " is not one of " + LegalNames<Enum>(), Quote(name));
      }
    }
    return values;
  }

  RuleEffect ReadEffect(const Json& json, const std::string& at) {
    RuleEffect effect;
    if (json["of"] == Json::array({"all"})) {
      for (const auto& entry : EnumNames(AssetType{})) effect.types.push_back(entry.value);
    } else {
      effect.types = ReadNames<AssetType>(json["of"], at + "/of");
    }
    if (json.contains("season_variants")) {
      effect.season_variants = ReadValues(json["season_variants"], at + "/season_variants",
                                          effect.types, &AssetTypeValues::season_variants);
    }
    if (json.contains("materials")) {
      effect.materials = ReadValues(json["materials"], at + "/materials", effect.types,
                                    &AssetTypeValues::materials);
    }
    for (const auto& parameter : EnumNames(FineParameter{})) {
      const std::string key(parameter.name);
      if (!json.contains(key)) continue;
      effect.numbers[static_cast<std::size_t>(parameter.value)] =
          ReadNumber(json[key], at + "/" + key, parameter.value, effect.types);
    }
    return effect;
  }

  using Names = std::vector<std::string_view> AssetTypeValues::*;

  ValuesEffect ReadValues(const Json& json, const std::string& at,
                          const std::vector<AssetType>& types, Names names) {
    ValuesEffect effect;
    if (json.contains("exclude")) {
      for (std::size_t i = 0; i < json["exclude"].size(); ++i) {
        effect.exclude.push_back(
            ReadSelector(json["exclude"][i], at + "/exclude/" + std::to_string(i), types, names));
      }
    }
    if (json.contains("weights")) {
      for (const auto& [words, times] : json["weights"].items()) {
        CheckWords(words, at + "/weights/" + PointerToken(words), types, names);
        effect.weights.push_back({words, times.get<double>()});
      }
    }
    return effect;
  }

  ValueSelector ReadSelector(const Json& json, const std::string& at,
                             const std::vector<AssetType>& types, Names names) {
    ValueSelector selector;
    if (json.contains("words")) {
      selector.words = json["words"].get<std::string>();
      CheckWords(selector.words, at + "/words", types, names);
    }
    if (json.contains("snow_above")) selector.snow_above = json["snow_above"].get<double>();
    selector.out_of_season = json.contains("out_of_season");
    return selector;
  }

  // Words that name nothing are slips.
  void CheckWords(const std::string& words, const std::string& at,
                  const std::vector<AssetType>& types, Names names) {
    for (const AssetType type : types) {
      const auto& known = ValuesOf(type).*names;
      if (std::any_of(known.begin(), known.end(),
                      [&](std::string_view name) { return HasWords(name, words); })) {
        continue;
      }
      Add("unknown_value", at,
          Quote(words) + " stands in none of " + std::string(NameOf(type)) + "'s values, " +
              Join(std::vector<std::string>(known.begin(), known.end()), ", "),
          Quote(words));
    }
  }

  NumberEffect ReadNumber(const Json& json, const std::string& at, FineParameter parameter,
                          const std::vector<AssetType>& types) {
    for (const AssetType type : types) {
      if (HasParameter(ValuesOf(type), parameter)) continue;
      Add("unknown_key", at,
          std::string(NameOf(type)) + " has no " + std::string(NameOf(parameter)),
          std::string(NameOf(parameter)));
    }
    NumberEffect effect;
    const Range legal{RangeOf(parameter).low, RangeOf(parameter).high};
    const auto read = [&](const char* key, std::optional<double>* value) {
      if (!json.contains(key)) return;
      *value = json[key].get<double>();
      CheckRange(at + "/" + key, **value, legal, "", violations_);
    };
    read("min", &effect.min);
    read("max", &effect.max);
    read("typical", &effect.typical);
    if (json.contains("factor")) effect.factor = json["factor"].get<double>();
    if (json.contains("evenly")) effect.evenly = json["evenly"].get<bool>();
    if (json.contains("draw")) {
      effect.draw = {json["draw"][0].get<double>(), json["draw"][1].get<double>()};
      CheckRange(at + "/draw/0", (*effect.draw)[0], legal, "", violations_);
      CheckRange(at + "/draw/1", (*effect.draw)[1], {(*effect.draw)[0], legal.high}, "",
                 violations_);
    }
    if (effect.min && effect.max) {
      CheckRange(at + "/max", *effect.max, {*effect.min, legal.high}, "", violations_);
    }
    return effect;
  }

  std::vector<Violation>* violations_;
  std::set<std::string> ids_;
};

}  // namespace

std::string_view RuleText() { return RuleFile("coarse_to_fine.json"); }
std::string_view RuleSchema() { return RuleFile("coarse_to_fine_schema.json"); }

Result<RuleBook> RuleBook::Parse(std::string_view text) {
  std::vector<Violation> violations;
  Json json;
  if (ParseStrictly(text, "", JsonLimits(), &json, &violations)) {
    SchemaChecker(RuleSchema()).Check(json, "", &violations);
  }
  // What does not obey the schema cannot be read any further.
  std::vector<Rule> rules;
  if (violations.empty()) rules = RuleReader(&violations).Read(json);
  LimitViolations(&violations);
  if (!violations.empty()) return Status::FromViolations("illegal rules", std::move(violations));
  return RuleBook(std::move(rules));
}

}  // namespace latticeworld
