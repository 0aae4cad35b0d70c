#include "latticeworld/common/schema_check.h"

#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <utility>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "latticeworld/common/strict_json.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kWrongType = "Value type not permitted";  // the library's words

// The value that a path of object keys and array indices leads to, with its pointer and the part of
// the schema that speaks about it.
struct Spot {
  const Json* value;
  const Json* schema;
  std::string pointer;
};

const Json* Resolve(const Json& schema_root, const Json* node) {
  while (node->is_object() && node->contains("$ref")) {
    const std::string target = node->at("$ref").get<std::string>();  // "#/definitions/..."
    node = &schema_root.at(Json::json_pointer(target.substr(1)));
  }
  return node;
}

void StepInto(const Json& schema_root, const std::string& token, Spot* spot) {
  if (spot->value->is_array()) {
    spot->value = &spot->value->at(std::stoul(token));
    spot->schema = Resolve(schema_root, &spot->schema->at("items"));
  } else {
    spot->value = &spot->value->at(token);
    const bool named =
        spot->schema->contains("properties") && spot->schema->at("properties").contains(token);
    spot->schema = Resolve(schema_root, named ? &spot->schema->at("properties").at(token)
                                              : &spot->schema->at("additionalProperties"));
  }
  spot->pointer += "/" + PointerToken(token);
}

std::string KeysOf(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return Join(keys, ", ");
}

// "a number in [0, 1]", "a number in (0, 20]", "a number".
std::string LegalNumber(const Json& schema) {
  const bool open = schema.contains("exclusiveMinimum");
  const char* low = open ? "exclusiveMinimum" : "minimum";
  if (!schema.contains(low) || !schema.contains("maximum")) return "a number";
  return std::string("a number in ") + (open ? "(" : "[") +
         FormatDouble(schema.at(low).get<double>()) + ", " +
         FormatDouble(schema.at("maximum").get<double>()) + "]";
}

// "an array of 1 to 64 elements"
std::string LegalArray(const Json& schema) {
  const std::string least = std::to_string(schema.value("minItems", 0));
  if (!schema.contains("maxItems")) return "an array of " + least + " elements at least";
  return "an array of " + least + " to " + std::to_string(schema.at("maxItems").get<int>()) +
         " elements";
}

std::string LegalObject(const Json& schema) {
  const std::string least =
      schema.contains("minProperties")
          ? ", " + std::to_string(schema.at("minProperties").get<int>()) + " at least"
          : "";
  if (!schema.contains("properties")) return "an object" + least;
  return "an object with keys of " + KeysOf(schema.at("properties")) + least;
}

// What the schema asks for.
std::string Legal(const Json& schema) {
  if (schema.contains("enum")) {
    std::vector<std::string> values;
    for (const Json& value : schema.at("enum")) {
      values.push_back(value.is_string() ? value.get<std::string>() : value.dump());
    }
    return "one of " + Join(values, ", ");
  }
  const std::string type = schema.at("type").get<std::string>();
  if (type == "number") return LegalNumber(schema);
  if (type == "array") return LegalArray(schema);
  if (type == "object") return LegalObject(schema);
  if (type == "boolean") return "true or false";
  if (schema.contains("title")) return schema.at("title").get<std::string>();
  return "a text of at most " + std::to_string(schema.value("maxLength", 1000)) + " characters";
}

// Writes the library's errors in this project's words.
class Translator {
 public:
  Translator(const Json& schema_root, const Json& document, const std::string& origin,
             std::vector<Violation>* violations)
      : schema_root_(schema_root), document_(document), origin_(origin), violations_(violations) {}

  void Translate(const valijson::ValidationResults::Error& error) {
    const Spot spot = Find(error.context);
    const std::string_view text = error.description;
    constexpr std::string_view kMissing = "Missing required property '";
    if (StartsWith(text, kMissing)) {
      const std::string_view key =
          text.substr(kMissing.size(), text.find('\'', kMissing.size()) - kMissing.size());
      AddMissing(spot, std::string(key));
    } else if (StartsWith(text, "Object contains a property")) {
      AddUnknown(spot);
    } else if (StartsWith(text, kWrongType)) {
      Add("wrong_type", spot);
    } else if (StartsWith(text, "Expected number")) {
      Add("out_of_range", spot);
    } else if (StartsWith(text, "Failed to match against any enum")) {
      Add("unknown_value", spot);
    } else if (StartsWith(text, "Failed to match regex") || StartsWith(text, "String should")) {
      Add("bad_format", spot);
    } else if (StartsWith(text, "Array should") || StartsWith(text, "Object should")) {
      Add("wrong_count", spot);
    } else if (StartsWith(text, "Elements at indexes")) {
      AddDuplicate(spot);
    } else if (!StartsWith(text, "Failed to validate")) {  // those only repeat what is below
      violations_->push_back({"schema", spot.pointer, Quote(text, 300), GivenAt(spot)});
    }
  }

 private:
  Spot Find(const std::vector<std::string>& context) const {
    Spot spot = {&document_, &schema_root_, origin_};
    for (std::size_t i = 1; i < context.size(); ++i) {  // after "<root>": "[key]" or "[3]"
      StepInto(schema_root_, context[i].substr(1, context[i].size() - 2), &spot);
    }
    return spot;
  }

  static std::string GivenAt(const Spot& spot) {
    if (spot.value->is_string()) return Quote(spot.value->get<std::string>());
    const std::string quoted = Quote(spot.value->dump());  // cut, with quotation marks around it
    return quoted.substr(1, quoted.size() - 2);
  }

  // One value is reported once, as what comes first: a number is neither a string nor one of these.
  void Add(const char* code, const Spot& spot) {
    if (!reported_.insert(spot.pointer).second) return;
    const std::string given =
        std::string(code) == "wrong_count"
            ? (spot.value->is_array() ? "an array of " : "an object of ") +
                  std::to_string(spot.value->size())
            : GivenAt(spot) + (std::string(code) == "wrong_type"
                                   ? " (" + std::string(spot.value->type_name()) + ")"
                                   : "");
    violations_->push_back(
        {code, spot.pointer, "must be " + Legal(*spot.schema) + ", not " + given, GivenAt(spot)});
  }

  void AddMissing(const Spot& spot, const std::string& key) {
    const Json& wanted = *Resolve(schema_root_, &spot.schema->at("properties").at(key));
    violations_->push_back({"missing_key", spot.pointer + "/" + PointerToken(key),
                            "is missing; it must be " + Legal(wanted), ""});
  }

  void AddUnknown(const Spot& spot) {
    const Json& legal = spot.schema->at("properties");
    for (const auto& [key, value] : spot.value->items()) {
      if (legal.contains(key)) continue;
      violations_->push_back({"unknown_key", spot.pointer + "/" + PointerToken(key),
                              Quote(key) + " is not one of " + KeysOf(legal), Quote(key)});
    }
  }

  void AddDuplicate(const Spot& spot) {
    if (!reported_.insert(spot.pointer).second) return;
    violations_->push_back(
        {"duplicate_value", spot.pointer, "has an element twice: " + GivenAt(spot), GivenAt(spot)});
  }

  const Json& schema_root_;
  const Json& document_;
  const std::string& origin_;
  std::vector<Violation>* violations_;
  std::set<std::string> reported_;  // pointers
};

}  // namespace

struct SchemaChecker::Parts {
  Json json;
  valijson::Schema schema;
};

SchemaChecker::SchemaChecker(std::string_view schema) : parts_(std::make_unique<Parts>()) {
  parts_->json = Json::parse(schema);
  valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(parts_->json), parts_->schema);
}

SchemaChecker::~SchemaChecker() = default;

void SchemaChecker::Check(const Json& document, const std::string& origin,
                          std::vector<Violation>* violations) const {
  valijson::Validator validator(valijson::Validator::kStrongTypes);
  valijson::ValidationResults results;
  const bool is_valid = validator.validate(
      parts_->schema, valijson::adapters::NlohmannJsonAdapter(document), &results);
  if (is_valid) return;
  const std::size_t before = violations->size();
  Translator translator(parts_->json, document, origin, violations);
  // If a value has the wrong type, nothing else about it is worth saying.
  for (const bool is_type : {true, false}) {
    for (const auto& error : results) {
      if (StartsWith(error.description, kWrongType) == is_type) translator.Translate(error);
    }
  }
  if (violations->size() == before) {
    violations->push_back({"schema", origin, "does not keep to the schema", ""});
  }
}

}  // namespace latticeworld
