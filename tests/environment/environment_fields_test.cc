// Every field of a whole document, broken in every way that it can be.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/environment/environment_config.h"

namespace latticeworld {
namespace {

using Json = nlohmann::ordered_json;
using Pointer = Json::json_pointer;

Json WholeDocument() {
  EnvironmentConfig environment;
  environment.fine = DeriveFineAttributes(environment.coarse);
  environment.agents = {
      {AgentCategory::kSheep, 9, AgentState::kGrazing, Region::kLowerLeft},
      {AgentCategory::kEagle, 1, AgentState::kFlying, Region::kAnywhere},
  };
  return Json::parse(ToJson(environment));
}

// Pointers to every value of a document below its root, containers too.
void Collect(const Json& json, const Pointer& at, std::vector<Pointer>* pointers) {
  if (!at.empty()) pointers->push_back(at);
  if (!json.is_structured()) return;
  const bool is_array = json.is_array();
  std::size_t index = 0;
  for (const auto& item : json.items()) {
    Collect(item.value(), is_array ? at / index : at / item.key(), pointers);
    ++index;
  }
}

std::vector<Pointer> AllFields() {
  std::vector<Pointer> pointers;
  Collect(WholeDocument(), Pointer(), &pointers);
  return pointers;
}

bool IsElement(const Pointer& at) { return WholeDocument().at(at.parent_pointer()).is_array(); }

// "code pointer" of the one violation; all of them when there are more.
std::string FaultOf(const std::string& text) {
  const Result<EnvironmentConfig> read = ParseEnvironment(text);
  if (read.ok()) return "legal";
  EXPECT_EQ(read.status().code(), StatusCode::kInvalidArgument);
  std::string faults;
  for (const Violation& violation : read.status().violations()) {
    EXPECT_FALSE(violation.message.empty());
    faults += (faults.empty() ? "" : "; ") + violation.code + " " + violation.pointer;
  }
  return faults;
}

std::string FaultWith(const Pointer& at, const Json& value) {
  Json json = WholeDocument();
  json.at(at) = value;
  return FaultOf(json.dump());
}

TEST(EnvironmentFieldsTest, TheDocumentItselfIsLegalAndWhole) {
  EXPECT_EQ(FaultOf(WholeDocument().dump()), "legal");
  EXPECT_GT(AllFields().size(), 90u);
}

TEST(EnvironmentFieldsTest, EachThatIsMissingIsNamed) {
  for (const Pointer& at : AllFields()) {
    Json json = WholeDocument();
    if (IsElement(at)) {
      // An array of agents may lack any; one of angles is then no longer one of three.
      if (at.parent_pointer().to_string() == "/agents") continue;
      Json& array = json.at(at.parent_pointer());
      array.erase(std::stoul(at.back()));
      EXPECT_EQ(FaultOf(json.dump()), "wrong_type " + at.parent_pointer().to_string());
    } else {
      json.at(at.parent_pointer()).erase(at.back());
      EXPECT_EQ(FaultOf(json.dump()), "missing_key " + at.to_string());
    }
  }
}

TEST(EnvironmentFieldsTest, EachOfAWrongTypeIsNamed) {
  for (const Pointer& at : AllFields()) {
    const Json legal = WholeDocument().at(at);
    for (const Json& wrong :
         {Json(nullptr), Json(true), Json("word"), Json(0.5), Json::array(), Json::object()}) {
      const bool same = wrong.type() == legal.type() || (wrong.is_number() && legal.is_number());
      if (same && !(legal.is_number_integer() && wrong.is_number_float())) continue;
      if (legal.is_number_integer() && wrong.is_number_float()) {
        // Only a quantity must be whole; 0 and 0.0 are the same number elsewhere.
        if (at.back() != "quantity") continue;
      }
      EXPECT_EQ(FaultWith(at, wrong), "wrong_type " + at.to_string()) << wrong;
    }
  }
}

TEST(EnvironmentFieldsTest, EachNumberOutOfRangeIsNamed) {
  int numbers = 0;
  for (const Pointer& at : AllFields()) {
    if (!WholeDocument().at(at).is_number()) continue;
    ++numbers;
    for (const Json& wrong : {Json(-5.01), Json(1e300), Json(-1e300), Json(361)}) {
      const bool is_quantity = at.back() == "quantity";
      if (is_quantity && wrong.is_number_float()) continue;
      if (is_quantity && wrong == 361) continue;
      EXPECT_EQ(FaultWith(at, wrong), "out_of_range " + at.to_string()) << wrong;
    }
    if (at.back() == "quantity") {
      for (const Json& wrong : {Json(0), Json(-1), Json(501), Json(10000), Json(1ULL << 63)}) {
        EXPECT_EQ(FaultWith(at, wrong), "out_of_range " + at.to_string()) << wrong;
      }
    }
  }
  EXPECT_GT(numbers, 35);
}

TEST(EnvironmentFieldsTest, EachNameThatIsUnknownIsNamed) {
  int names = 0;
  for (const Pointer& at : AllFields()) {
    const Json legal = WholeDocument().at(at);
    if (!legal.is_string()) continue;
    ++names;
    for (const Json& wrong : {Json("plastic"), Json(""), Json(legal.get<std::string>() + " "),
                              Json(std::string("A\0b", 3)), Json(std::string(5000, 'x'))}) {
      EXPECT_EQ(FaultWith(at, wrong), "unknown_value " + at.to_string());
    }
  }
  EXPECT_EQ(names, 5 + 2 * kAssetTypeCount + 2 * 3);
}

TEST(EnvironmentFieldsTest, AnUnknownKeyInEachObjectIsNamed) {
  std::vector<Pointer> objects = AllFields();
  objects.emplace_back();
  for (const Pointer& at : objects) {
    Json json = WholeDocument();
    if (!json.at(at).is_object()) continue;
    json.at(at)["colour"] = 1;
    EXPECT_EQ(FaultOf(json.dump()), "unknown_key " + at.to_string() + "/colour");
  }
}

// Writes a document with one member twice, which no JSON library does.
void Write(const Json& json, const Pointer& at, const Pointer& twice, std::string* text) {
  if (!json.is_structured()) {
    *text += json.dump();
    return;
  }
  const bool is_array = json.is_array();
  *text += is_array ? "[" : "{";
  std::size_t index = 0;
  for (const auto& item : json.items()) {
    const Pointer here = is_array ? at / index : at / item.key();
    for (int i = here == twice ? 2 : 1; i > 0; --i) {
      if (text->back() != '[' && text->back() != '{') *text += ",";
      if (!is_array) *text += Json(item.key()).dump() + ":";
      Write(item.value(), here, twice, text);
    }
    ++index;
  }
  *text += is_array ? "]" : "}";
}

TEST(EnvironmentFieldsTest, EachThatStandsTwiceIsNamed) {
  for (const Pointer& at : AllFields()) {
    if (IsElement(at)) continue;
    std::string text;
    Write(WholeDocument(), Pointer(), at, &text);
    EXPECT_EQ(FaultOf(text), "duplicate_key " + at.to_string());
  }
}

Json Sheep(int quantity) {
  return {{"category", "sheep"}, {"quantity", quantity}, {"state", "idle"}, {"position", "center"}};
}

TEST(EnvironmentFieldsTest, TenThousandAgentsAreTooMany) {
  Json json = WholeDocument();
  json["agents"] = Json::array();
  for (int i = 0; i < 20; ++i) json["agents"].push_back(Sheep(500));
  const Status status = ParseEnvironment(json.dump()).status();
  ASSERT_EQ(status.violations().size(), 1u);
  EXPECT_EQ(status.violations()[0].code, "out_of_range");
  EXPECT_EQ(status.violations()[0].pointer, "/agents");
  EXPECT_EQ(status.violations()[0].message, "10000 agents in all; at most 1000 are legal");
  EXPECT_EQ(status.violations()[0].given, "10000");

  // As ten thousand groups of one as well, however the document is written.
  json["agents"] = Json::array();
  for (int i = 0; i < 10000; ++i) json["agents"].push_back(Sheep(1));
  const Status many = ParseEnvironment(json.dump()).status();
  ASSERT_EQ(many.violations().size(), 1u);
  EXPECT_EQ(many.violations()[0].code, "out_of_range");
  EXPECT_EQ(many.violations()[0].pointer, "/agents");
  EXPECT_EQ(many.violations()[0].message,
            "more than 1000 groups; at most 1000 agents in all are legal");

  json["agents"] = Json::array();
  for (int i = 0; i < 1000; ++i) json["agents"].push_back(Sheep(1));
  EXPECT_EQ(FaultOf(json.dump()), "legal");
}

}  // namespace
}  // namespace latticeworld
