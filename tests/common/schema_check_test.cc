#include "latticeworld/common/schema_check.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

namespace latticeworld {
namespace {

constexpr char kSchema[] = R"({
  "type": "object",
  "additionalProperties": false,
  "required": ["name"],
  "properties": {
    "name": {"type": "string", "pattern": "^[a-z]+$", "title": "a word", "maxLength": 5},
    "share": {"type": "number", "exclusiveMinimum": 0, "maximum": 1},
    "any": {"type": "number"},
    "flag": {"type": "boolean"},
    "color": {"enum": ["red", "blue"]},
    "list": {"type": "array", "minItems": 1, "maxItems": 3, "uniqueItems": true,
             "items": {"$ref": "#/definitions/number"}},
    "weights": {"type": "object", "minProperties": 1,
                "additionalProperties": {"$ref": "#/definitions/number"}}
  },
  "definitions": {"number": {"type": "number", "minimum": -1, "maximum": 1}}
})";

struct Sample {
  std::string document;
  std::string fault;  // "code pointer: message"
};
void PrintTo(const Sample& sample, std::ostream* os) { *os << sample.document; }

class SchemaCheck : public testing::TestWithParam<Sample> {};

TEST_P(SchemaCheck, SaysWhatIsWrongWhereAndWhatIsLegal) {
  std::vector<Violation> violations;
  SchemaChecker(kSchema).Check(nlohmann::json::parse(GetParam().document), "f#", &violations);
  std::string faults;
  for (const Violation& violation : violations) {
    faults += (faults.empty() ? "" : "\n") + violation.code + " " + violation.pointer + ": " +
              violation.message;
  }
  EXPECT_EQ(faults, GetParam().fault);
}

INSTANTIATE_TEST_SUITE_P(
    Documents, SchemaCheck,
    testing::ValuesIn(std::vector<Sample>{
        {R"({"name": "oak", "share": 1, "flag": true, "color": "red", "list": [0, 1], "weights": {"x": 1}})",
         ""},
        {R"({})", "missing_key f#/name: is missing; it must be a word"},
        {R"([])",
         "wrong_type f#: must be an object with keys of any, color, flag, list, name, share, "
         "weights, not [] (array)"},
        {R"({"name": "oak", "size": 1})",
         "unknown_key f#/size: \"size\" is not one of any, color, flag, list, name, share, "
         "weights"},
        {R"({"name": 3})", "wrong_type f#/name: must be a word, not 3 (number)"},
        {R"({"name": "Oak"})", "bad_format f#/name: must be a word, not \"Oak\""},
        {R"({"name": "oak", "share": 0})",
         "out_of_range f#/share: must be a number in (0, 1], not 0"},
        {R"({"name": "oak", "any": "1"})",
         "wrong_type f#/any: must be a number, not \"1\" (string)"},
        {R"({"name": "oak", "flag": 1})",
         "wrong_type f#/flag: must be true or false, not 1 (number)"},
        {R"({"name": "oak", "color": "green"})",
         "unknown_value f#/color: must be one of red, blue, not \"green\""},
        {R"({"name": "oak", "list": []})",
         "wrong_count f#/list: must be an array of 1 to 3 elements, not an array of 0"},
        {R"({"name": "oak", "list": [0, 2]})",
         "out_of_range f#/list/1: must be a number in [-1, 1], not 2"},
        {R"({"name": "oak", "list": [0, 0]})",
         "duplicate_value f#/list: has an element twice: [0,0]"},
        {R"({"name": "oak", "weights": {}})",
         "wrong_count f#/weights: must be an object, 1 at least, not an object of 0"},
        {R"({"name": "oak", "weights": {"x": 1, "y/z": 2}})",
         "out_of_range f#/weights/y~1z: must be a number in [-1, 1], not 2"},
    }));

TEST(SchemaCheckTest, AllFaultsComeAtOnce) {
  std::vector<Violation> violations;
  SchemaChecker(kSchema).Check(
      nlohmann::json::parse(R"({"share": 2, "flag": 1, "list": [5, 6], "x": 0, "y": 0})"), "",
      &violations);
  EXPECT_EQ(violations.size(), 7u);
}

}  // namespace
}  // namespace latticeworld
