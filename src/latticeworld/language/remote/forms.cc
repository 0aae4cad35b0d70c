#include "latticeworld/language/remote/forms.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "latticeworld/environment/environment_config.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMostGroups = 64;

// A step between values, as a fraction so that its multiples are exact.
struct Step {
  int units;
  int per;
};
constexpr Step kSteps[] = {{1, 10}, {1, 4}, {1, 2}, {1, 1}, {2, 1}, {5, 1}, {10, 1}, {15, 1}};
constexpr int kMostValues = 24;

// The multiples of a step that a schema of a number accepts.
Json Multiples(const Json& number, const Step& step) {
  const double low = number.at("minimum");
  const bool open = number.contains("exclusiveMaximum");
  const double high = number.at(open ? "exclusiveMaximum" : "maximum");
  Json values = Json::array();
  for (int i = static_cast<int>(std::ceil(low * step.per / step.units));; ++i) {
    const double value = static_cast<double>(i) * step.units / step.per;
    if (value > high || (open && value == high)) return values;
    if (step.per == 1) {
      values.push_back(i * step.units);
    } else {
      values.push_back(value);
    }
  }
}

// A range of numbers as a few values that every grammar can spell.
Json Steps(const Json& number) {
  Json values;
  for (const Step& step : kSteps) {
    values = Multiples(number, step);
    if (values.size() <= kMostValues) break;
  }
  return {{"type", "number"}, {"enum", std::move(values)}};
}

// Depth: that of the schema, which this program made itself.
void MakeEnforceable(Json* schema) {
  if (schema->is_object() && schema->contains("enum") && !schema->contains("type")) {
    *schema = {{"type", "string"}, {"enum", schema->at("enum")}};
    return;
  }
  if (schema->is_object() && schema->contains("type") && schema->at("type") == "number") {
    *schema = Steps(*schema);
    return;
  }
  if (!schema->is_structured()) return;
  for (Json& child : *schema) MakeEnforceable(&child);
}

}  // namespace

AnswerForm LayoutForm(Vocabulary vocabulary) {
  std::string letters;
  for (const LayoutClass& entry : ClassesOf(vocabulary)) letters += entry.letter;
  const std::string size = std::to_string(kLayoutSize);
  const std::string but_last = std::to_string(kLayoutSize - 1);
  const std::string row = "[" + letters + "]{" + size + "}";

  AnswerForm form;
  form.name = "layout";
  form.gbnf = "root ::= line{" + but_last + "} row\nline ::= row \"\\n\"\nrow ::= " + row + "\n";
  form.regex = "(" + row + "\\n){" + but_last + "}" + row;
  const Json rows = {{"type", "array"},
                     {"items", {{"type", "string"}, {"pattern", "^" + row + "$"}}},
                     {"minItems", kLayoutSize},
                     {"maxItems", kLayoutSize}};
  const Json schema = {{"type", "object"},
                       {"properties", {{"rows", rows}}},
                       {"required", {"rows"}},
                       {"additionalProperties", false}};
  form.json_schema = schema.dump();
  return form;
}

AnswerForm EnvironmentForm(const Catalogue& catalogue) {
  Json schema = Json::parse(EnvironmentSchema(catalogue));
  schema.erase("$schema");
  schema.erase("title");
  schema.erase("description");
  MakeEnforceable(&schema);
  schema["properties"]["agents"]["maxItems"] = kMostGroups;
  AnswerForm form;
  form.name = "environment";
  form.json_schema = schema.dump();
  return form;
}

}  // namespace latticeworld
