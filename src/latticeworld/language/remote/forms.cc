#include "latticeworld/language/remote/forms.h"

#include <nlohmann/json.hpp>
#include <string>

#include "latticeworld/environment/environment_config.h"
#include "latticeworld/language/remote/number_steps.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMostGroups = 64;

// A number's schema as a few values.
Json Steps(const Json& number) {
  const bool open = number.contains("exclusiveMaximum");
  const NumberSteps steps(
      Range{number.at("minimum"), number.at(open ? "exclusiveMaximum" : "maximum"), false, open});
  Json values = Json::array();
  for (int i = 0; i < steps.count(); ++i) {
    if (steps.whole()) {
      values.push_back(static_cast<int>(steps.At(i)));
    } else {
      values.push_back(steps.At(i));
    }
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
