#include "language/remote/form_checkers.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace latticeworld {
namespace {

using Json = nlohmann::ordered_json;

class Gbnf {
 public:
  explicit Gbnf(const std::string& grammar) {
    std::istringstream lines(grammar);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t sign = line.find(" ::= ");
      if (sign == std::string::npos) throw std::invalid_argument("no rule: " + line);
      rules_[line.substr(0, sign)] = line.substr(sign + 5);
    }
  }

  // The position after what a rule matches of text from `at`.
  std::optional<std::size_t> Match(const std::string& name, std::string_view text,
                                   std::size_t at) const {
    const std::string& rule = rules_.at(name);
    for (std::size_t i = 0; i < rule.size();) {
      if (rule[i] == ' ') {
        ++i;
        continue;
      }
      const std::size_t begin = i;
      const char closing = rule[i] == '"' ? '"' : rule[i] == '[' ? ']' : '\0';
      if (closing != '\0') {
        i = rule.find(closing, i + 1) + 1;
      } else {
        while (i < rule.size() && std::isalpha(static_cast<unsigned char>(rule[i]))) ++i;
      }
      const std::string element = rule.substr(begin, i - begin);
      if (element.empty()) throw std::invalid_argument("unknown sign in rule: " + rule);
      int times = 1;
      if (i < rule.size() && rule[i] == '{') {
        const std::size_t end = rule.find('}', i);
        times = std::stoi(rule.substr(i + 1, end - i - 1));
        if (times > 2000) throw std::invalid_argument("llama.cpp refuses more repetitions");
        i = end + 1;
      }
      for (int k = 0; k < times; ++k) {
        const auto next = MatchElement(element, text, at);
        if (!next) return std::nullopt;
        at = *next;
      }
    }
    return at;
  }

 private:
  std::optional<std::size_t> MatchElement(const std::string& element, std::string_view text,
                                          std::size_t at) const {
    const std::string inner = element.substr(1, element.size() - 2);
    if (element[0] == '[') {
      const bool found = at < text.size() && inner.find(text[at]) != std::string::npos;
      return found ? std::optional(at + 1) : std::nullopt;
    }
    if (element[0] == '"') {
      const std::string literal = inner == "\\n" ? "\n" : inner;
      if (text.substr(std::min(at, text.size()), literal.size()) != literal) return std::nullopt;
      return at + literal.size();
    }
    return Match(element, text, at);
  }

  std::map<std::string, std::string> rules_;
};

// ^[ABC]{32}$ as its letters and their number.
std::pair<std::string, std::size_t> PatternParts(const std::string& pattern) {
  const std::size_t bracket = pattern.find("]{");
  if (pattern.compare(0, 2, "^[") != 0 || pattern.compare(pattern.size() - 2, 2, "}$") != 0 ||
      bracket == std::string::npos) {
    throw std::invalid_argument("unknown pattern: " + pattern);
  }
  return {pattern.substr(2, bracket - 2), std::stoul(pattern.substr(bracket + 2))};
}

void RefuseUnknownKeywords(const Json& schema) {
  static const std::vector<std::string> kKnown = {
      "type",     "enum",    "properties", "required", "additionalProperties", "items", "minItems",
      "maxItems", "minimum", "maximum",    "pattern",  "description"};
  for (const auto& [key, value] : schema.items()) {
    if (std::find(kKnown.begin(), kKnown.end(), key) == kKnown.end()) {
      throw std::invalid_argument("keyword that servers may not know: " + key);
    }
  }
  if (!schema.contains("type")) throw std::invalid_argument("no type: " + schema.dump());
}

bool Accepts(const Json& schema, const Json& json) {
  RefuseUnknownKeywords(schema);
  const std::string type = schema.at("type");
  if (schema.contains("enum")) {
    const Json& values = schema.at("enum");
    if (std::find(values.begin(), values.end(), json) == values.end()) return false;
  }
  if (type == "string") {
    if (!json.is_string()) return false;
    if (!schema.contains("pattern")) return true;
    const auto [letters, size] = PatternParts(schema.at("pattern"));
    const std::string text = json;
    return text.size() == size && text.find_first_not_of(letters) == std::string::npos;
  }
  if (type == "integer") {
    return json.is_number_integer() && json.get<int>() >= schema.at("minimum").get<int>() &&
           json.get<int>() <= schema.at("maximum").get<int>();
  }
  if (type == "number") return json.is_number();
  if (type == "array") {
    if (!json.is_array() || json.size() < schema.value("minItems", 0u) ||
        json.size() > schema.value("maxItems", 1000000u)) {
      return false;
    }
    return std::all_of(json.begin(), json.end(),
                       [&](const Json& one) { return Accepts(schema.at("items"), one); });
  }
  if (type != "object") throw std::invalid_argument("unknown type " + type);
  if (!json.is_object() || json.size() != schema.at("properties").size()) return false;
  if (schema.at("additionalProperties") != false ||
      schema.at("required").size() != schema.at("properties").size()) {
    throw std::invalid_argument("strict servers want every property required and no other");
  }
  for (const auto& [key, value] : schema.at("properties").items()) {
    if (!json.contains(key) || !Accepts(value, json.at(key))) return false;
  }
  return true;
}

Json Random(const Json& schema, RandomStream* random) {
  RefuseUnknownKeywords(schema);
  const std::string type = schema.at("type");
  if (schema.contains("enum")) {
    const Json& values = schema.at("enum");
    return values[static_cast<std::size_t>(
        random->UniformInt(0, static_cast<int>(values.size()) - 1))];
  }
  if (type == "integer") return random->UniformInt(schema.at("minimum"), schema.at("maximum"));
  if (type == "string") {
    const auto [letters, size] = PatternParts(schema.at("pattern"));
    std::string text;
    while (text.size() < size) {
      text += letters[static_cast<std::size_t>(
          random->UniformInt(0, static_cast<int>(letters.size()) - 1))];
    }
    return text;
  }
  if (type == "array") {
    const int least = schema.value("minItems", 0);
    const int most = std::min(schema.value("maxItems", 8), std::max(least, 8));
    Json array = Json::array();
    const int size = random->UniformInt(least, most);
    for (int i = 0; i < size; ++i) array.push_back(Random(schema.at("items"), random));
    return array;
  }
  if (type != "object") throw std::invalid_argument("unbounded " + type);
  Json object = Json::object();
  for (const auto& [key, value] : schema.at("properties").items()) {
    object[key] = Random(value, random);
  }
  return object;
}

}  // namespace

bool MatchesGbnf(const std::string& grammar, std::string_view text) {
  return Gbnf(grammar).Match("root", text, 0) == text.size();
}

bool MatchesSchema(const std::string& schema, const std::string& json) {
  return Accepts(Json::parse(schema), Json::parse(json));
}

std::string RandomInstance(const std::string& schema, RandomStream* random) {
  return Random(Json::parse(schema), random).dump();
}

}  // namespace latticeworld
