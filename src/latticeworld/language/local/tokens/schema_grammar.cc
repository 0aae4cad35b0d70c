#include "latticeworld/language/local/tokens/schema_grammar.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>
#include <vector>

namespace latticeworld {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMostDepth = 64;
constexpr int kMostItems = 1000;
constexpr std::int64_t kMostInteger = 1'000'000'000'000;

// A text as a literal of the grammar.
std::string Literal(const std::string& text) {
  std::string literal = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') literal += '\\';
    if (c == '\n') {
      literal += "\\n";
    } else {
      literal += c;
    }
  }
  return literal + "\"";
}

std::string AnyDigits(std::size_t count) {
  if (count == 0) return std::string();
  return " [0-9]{" + std::to_string(count) + "}";
}

// Numbers of as many digits as both ends, which have the same number of them.
std::string SameLength(const std::string& low, const std::string& high) {
  if (low.empty()) return "\"\"";
  const bool all = low.find_first_not_of('0') == std::string::npos &&
                   high.find_first_not_of('9') == std::string::npos;
  if (all) return AnyDigits(low.size());
  const std::string low_rest = low.substr(1), high_rest = high.substr(1);
  if (low[0] == high[0])
    return Literal(low.substr(0, 1)) + " (" + SameLength(low_rest, high_rest) + ")";
  std::string ways = Literal(low.substr(0, 1)) + " (" +
                     SameLength(low_rest, std::string(low_rest.size(), '9')) + ")";
  if (high[0] - low[0] > 1)
    ways += std::string(" | [") + static_cast<char>(low[0] + 1) + "-" +
            static_cast<char>(high[0] - 1) + "]" + AnyDigits(low_rest.size());
  return ways + " | " + Literal(high.substr(0, 1)) + " (" +
         SameLength(std::string(high_rest.size(), '0'), high_rest) + ")";
}

// Whole numbers from low to high, 0 <= low <= high.
std::string NaturalNumbers(std::int64_t low, std::int64_t high) {
  std::string ways;
  for (std::int64_t from = low; from <= high;) {
    const std::string digits = std::to_string(from);
    const std::string nines(digits.size(), '9');
    const std::int64_t to = std::min<std::int64_t>(high, std::stoll(nines));
    ways += (ways.empty() ? "" : " | ") + SameLength(digits, std::to_string(to));
    from = to + 1;
  }
  return ways;
}

std::string Integers(std::int64_t low, std::int64_t high) {
  std::string ways;
  if (low < 0) ways = "\"-\" (" + NaturalNumbers(std::max<std::int64_t>(-high, 1), -low) + ")";
  if (high >= 0)
    ways += (ways.empty() ? "" : " | ") + NaturalNumbers(std::max<std::int64_t>(low, 0), high);
  return "(" + ways + ")";
}

class Writer {
 public:
  Result<std::string> Write(const Json& schema) {
    const std::string root = Value(schema, "", 0);
    LW_RETURN_IF_ERROR(status_);
    std::string grammar = "root ::= " + root + "\n";
    for (const std::string& rule : rules_) grammar += rule;
    return grammar;
  }

 private:
  std::string Fail(const std::string& pointer, const std::string& what) {
    if (status_.ok()) status_ = InvalidArgument("schema, '" + pointer + "': " + what);
    return "\"\"";
  }

  // Fails if the schema has other members than these: what they say would not be kept.
  bool HasOnly(const Json& schema, const std::string& pointer, const std::set<std::string>& known) {
    static const std::set<std::string> kWords = {"type", "title", "description", "$schema", "$id"};
    for (const auto& [key, value] : schema.items()) {
      if (known.count(key) != 0 || kWords.count(key) != 0) continue;
      Fail(pointer, "'" + key + "' is not read here");
      return false;
    }
    return true;
  }

  std::string Value(const Json& schema, const std::string& pointer, int depth) {
    if (!schema.is_object()) return Fail(pointer, "a schema is an object");
    if (depth > kMostDepth) return Fail(pointer, "schemas within schemas too deep");
    if (schema.contains("enum")) return Enum(schema, pointer);
    if (schema.contains("const")) return Literal(schema.at("const").dump());
    const std::string type = schema.contains("type") && schema.at("type").is_string()
                                 ? schema.at("type").get<std::string>()
                                 : std::string();
    if (type == "object") return Object(schema, pointer, depth);
    if (type == "array") return Array(schema, pointer, depth);
    if (type == "integer") return Integer(schema, pointer);
    if (type == "string" && HasOnly(schema, pointer, {}))
      return "\"\\\"\" ([ !#-\\[\\]-~] | \"\\\\\" [\"\\\\nt]){0,256} \"\\\"\"";
    if (type == "number" && HasOnly(schema, pointer, {}))
      return "(\"-\"? (\"0\" | [1-9] [0-9]{0,8}) (\".\" [0-9]{1,6})?)";
    if (type == "boolean" && HasOnly(schema, pointer, {})) return "(\"true\" | \"false\")";
    if (type == "null" && HasOnly(schema, pointer, {})) return "\"null\"";
    return Fail(pointer, "the type '" + type + "' is not read here");
  }

  std::string Enum(const Json& schema, const std::string& pointer) {
    const Json& values = schema.at("enum");
    if (!HasOnly(schema, pointer, {"enum"})) return "\"\"";
    if (!values.is_array() || values.empty()) return Fail(pointer, "an enum without values");
    std::string ways;
    for (const Json& value : values) ways += (ways.empty() ? "(" : " | ") + Literal(value.dump());
    return ways + ")";
  }

  std::string Integer(const Json& schema, const std::string& pointer) {
    if (!HasOnly(schema, pointer, {"minimum", "maximum"})) return "\"\"";
    const auto limit = [&](const char* key, std::int64_t otherwise) {
      if (!schema.contains(key)) return otherwise;
      if (!schema.at(key).is_number_integer()) Fail(pointer, std::string(key) + " is no integer");
      return schema.at(key).is_number_integer() ? schema.at(key).get<std::int64_t>() : otherwise;
    };
    const std::int64_t low = limit("minimum", -kMostInteger);
    const std::int64_t high = limit("maximum", kMostInteger);
    if (low > high || low < -kMostInteger || high > kMostInteger)
      return Fail(pointer, "integers from " + std::to_string(low) + " to " + std::to_string(high));
    return Integers(low, high);
  }

  std::string Object(const Json& schema, const std::string& pointer, int depth) {
    if (!HasOnly(schema, pointer, {"properties", "required", "additionalProperties"}))
      return "\"\"";
    const Json properties = schema.value("properties", Json::object());
    const Json required = schema.value("required", Json::array());
    if (!properties.is_object() || !required.is_array() || required.size() != properties.size() ||
        schema.value("additionalProperties", Json(true)) != Json(false))
      return Fail(pointer, "objects have all their properties and no others here");
    std::string members;
    for (const auto& [key, value] : properties.items()) {
      if (std::find(required.begin(), required.end(), Json(key)) == required.end())
        return Fail(pointer, "'" + key + "' is not required");
      members += (members.empty() ? "" : " \",\" ") + Literal(Json(key).dump() + ":") + " " +
                 Value(value, pointer + "/" + key, depth + 1);
    }
    return Rule("\"{\" " + members + " \"}\"");
  }

  std::string Array(const Json& schema, const std::string& pointer, int depth) {
    if (!HasOnly(schema, pointer, {"items", "minItems", "maxItems"})) return "\"\"";
    const auto limit = [&](const char* key, int otherwise) {
      if (!schema.contains(key)) return otherwise;
      const Json& value = schema.at(key);
      if (value.is_number_integer() && value.get<std::int64_t>() >= 0 &&
          value.get<std::int64_t>() <= kMostItems)
        return value.get<int>();
      Fail(pointer, std::string(key) + " is no integer from 0 to " + std::to_string(kMostItems));
      return otherwise;
    };
    const int least = limit("minItems", 0), most = limit("maxItems", kMostItems);
    if (!schema.contains("items")) return Fail(pointer, "'items' is missing");
    if (least > most) return Fail(pointer, "more items at least than at most");
    if (most == 0) return "\"[]\"";
    const std::string item = Value(schema.at("items"), pointer + "/items", depth + 1);
    std::string items = item + " (\",\" " + item + "){" + std::to_string(std::max(least - 1, 0)) +
                        "," + std::to_string(most - 1) + "}";
    if (least == 0) items = "(" + items + ")?";
    return Rule("\"[\" " + items + " \"]\"");
  }

  std::string Rule(const std::string& body) {
    std::string name = "r" + std::to_string(rules_.size());
    rules_.push_back(name + " ::= " + body + "\n");
    return name;
  }

  std::vector<std::string> rules_;
  Status status_;
};

}  // namespace

Result<std::string> SchemaGrammar(std::string_view json_schema) {
  // Values are written and copied by recursion, so that depth costs stack. A schema within another
  // one takes two levels, and so much a constant may have.
  bool too_deep = false;
  const auto is_kept = [&too_deep](int depth, Json::parse_event_t, const Json&) {
    too_deep = too_deep || depth > 2 * kMostDepth;
    return !too_deep;
  };
  const Json schema = Json::parse(json_schema, is_kept, false);
  if (too_deep) return InvalidArgument("the schema is nested too deep");
  if (schema.is_discarded()) return InvalidArgument("the schema is no JSON");
  return Writer().Write(schema);
}

}  // namespace latticeworld
