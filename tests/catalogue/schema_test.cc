// The schema accepts what ships and refuses a file with any one field broken.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "catalogue/larch.h"
#include "latticeworld/catalogue/catalogue.h"

namespace latticeworld {

std::string_view CatalogueData(std::string_view file_name);  // embedded

namespace {

using Json = nlohmann::ordered_json;
using Pointer = Json::json_pointer;

TEST(CatalogueSchemaTest, IsDraft7AndDescribesTheTypes) {
  const Json schema = Json::parse(CatalogueSchema());
  EXPECT_EQ(schema.at("$schema"), "http://json-schema.org/draft-07/schema#");
  std::vector<std::string> types;
  for (const auto& type : EnumNames(AssetType{})) types.emplace_back(type.name);
  EXPECT_EQ(schema.at(Pointer("/properties/type/enum")).get<std::vector<std::string>>(), types);
}

// An enum that grows has to be told to the schema too.
TEST(CatalogueSchemaTest, KnowsTheNamesThatTheCodeKnows) {
  const Json schema = Json::parse(CatalogueSchema());
  const auto expect = [&](const std::string& pointer, const std::string& names) {
    std::string listed;
    for (const Json& name : schema.at(Pointer(pointer))) {
      listed += (listed.empty() ? "" : ", ") + name.get<std::string>();
    }
    EXPECT_EQ(listed, names);
  };
  const std::string model = "/definitions/model/properties/";
  expect(model + "kind/enum", LegalNames<AssetKind>());
  expect(model + "shape/enum", LegalNames<Shape>());
  expect(model + "collision/enum", LegalNames<Collision>());
  expect("/definitions/season/enum", LegalNames<Season>());
  expect("/definitions/density/properties/kind/enum", LegalNames<AssetKind>());
}

TEST(CatalogueSchemaTest, AcceptsEveryShippedFileAsAUsersFile) {
  std::vector<CatalogueFile> files;
  for (const auto& type : EnumNames(AssetType{})) {
    const std::string name = std::string(type.name) + ".json";
    files.push_back({name, std::string(CatalogueData(name))});
  }
  EXPECT_EQ(FaultsOf(files), std::vector<std::string>());
}

// Pointers to every value of a document, containers too.
void Collect(const Json& json, const Pointer& at, std::vector<Pointer>* pointers) {
  if (!at.empty()) pointers->push_back(at);
  if (!json.is_structured()) return;
  for (const auto& [key, value] : json.items()) {
    Collect(value, json.is_array() ? at / std::stoul(key) : at / key, pointers);
  }
}

std::vector<Pointer> PointersOfLarch() {
  std::vector<Pointer> pointers;
  Collect(Json::parse(LarchFile()), Pointer(), &pointers);
  EXPECT_GT(pointers.size(), 120u);
  return pointers;
}

void ExpectFault(const Json& broken, const std::string& fault) {
  const std::vector<std::string> faults = FaultsOf(broken.dump());
  EXPECT_NE(std::find(faults.begin(), faults.end(), fault), faults.end())
      << fault << " is not among " << ::testing::PrintToString(faults);
}

TEST(CatalogueSchemaTest, AcceptsAFileWithEveryKey) {
  EXPECT_EQ(FaultsOf(LarchFile()), std::vector<std::string>());
}

TEST(CatalogueSchemaTest, RefusesEveryValueOfTheWrongType) {
  for (const Pointer& pointer : PointersOfLarch()) {
    for (const Json& wrong : {Json(true), Json(nullptr)}) {
      Json broken = Json::parse(LarchFile());
      broken[pointer] = wrong;
      ExpectFault(broken, "wrong_type user.json#" + pointer.to_string());
    }
    Json broken = Json::parse(LarchFile());
    broken[pointer] = broken[pointer].is_number() ? Json("12") : Json(12);
    ExpectFault(broken, "wrong_type user.json#" + pointer.to_string());
  }
}

TEST(CatalogueSchemaTest, RefusesEveryNumberOutOfRange) {
  int numbers = 0;
  for (const Pointer& pointer : PointersOfLarch()) {
    Json broken = Json::parse(LarchFile());
    if (!broken[pointer].is_number()) continue;
    for (const double wrong : {-1e6, 1e300}) {
      broken[pointer] = wrong;
      ExpectFault(broken, "out_of_range user.json#" + pointer.to_string());
    }
    ++numbers;
  }
  EXPECT_GT(numbers, 50);
}

TEST(CatalogueSchemaTest, RefusesEveryTextThatIsNotOneOfTheLegal) {
  for (const Pointer& pointer : PointersOfLarch()) {
    Json broken = Json::parse(LarchFile());
    if (!broken[pointer].is_string()) continue;
    // Sources are free texts and have a length only.
    broken[pointer] = std::string(2000, '?');
    const std::vector<std::string> faults = FaultsOf(broken.dump());
    const std::string at = " user.json#" + pointer.to_string();
    const bool is_found = std::any_of(faults.begin(), faults.end(), [&](const std::string& fault) {
      return fault == "bad_format" + at || fault == "unknown_value" + at;
    });
    EXPECT_TRUE(is_found) << at << " is not among " << ::testing::PrintToString(faults);
  }
}

TEST(CatalogueSchemaTest, RefusesUnknownKeysInEveryObject) {
  for (const Pointer& pointer : PointersOfLarch()) {
    Json broken = Json::parse(LarchFile());
    if (!broken[pointer].is_object()) continue;
    broken[pointer]["colour"] = 1;
    ExpectFault(broken, "unknown_key user.json#" + (pointer / "colour").to_string());
  }
  Json broken = Json::parse(LarchFile());
  broken["colour"] = 1;
  broken["smell"] = "resin";
  EXPECT_EQ(FaultsOf(broken.dump()), std::vector<std::string>({"unknown_key user.json#/colour",
                                                               "unknown_key user.json#/smell"}));
}

// What can be left out is told here, once; all else is needed.
bool IsOptional(const std::string& pointer) {
  for (const char* name : {"sources",
                           "season_variants",
                           "materials",
                           "models",
                           "density",
                           "source",
                           "ground",
                           "crown_base",
                           "crown_widest",
                           "droop",
                           "habitat",
                           "altitude",
                           "slope_deg",
                           "wetness",
                           "northness",
                           "shade_tolerance",
                           "clumping",
                           "letters",
                           "suburb",
                           "wild",
                           "wood",
                           "G",
                           "F"}) {
    const std::string end = std::string("/") + name;
    if (pointer.size() >= end.size() &&
        pointer.compare(pointer.size() - end.size(), end.size(), end) == 0) {
      return true;
    }
  }
  return false;
}

TEST(CatalogueSchemaTest, RefusesEveryMissingKey) {
  int missing = 0;
  for (const Pointer& pointer : PointersOfLarch()) {
    Json broken = Json::parse(LarchFile());
    Json& parent = broken[pointer.parent_pointer()];
    if (!parent.is_object() || IsOptional(pointer.to_string())) continue;
    parent.erase(pointer.back());
    ExpectFault(broken, "missing_key user.json#" + pointer.to_string());
    ++missing;
  }
  EXPECT_GT(missing, 60);
}

// The keys of every object, written twice.
TEST(CatalogueSchemaTest, RefusesEveryDuplicateKey) {
  const std::string text = Json::parse(LarchFile()).dump();
  for (const Pointer& pointer : PointersOfLarch()) {
    Json marked = Json::parse(LarchFile());
    if (!marked[pointer.parent_pointer()].is_object()) continue;
    const std::string value = marked[pointer].dump();
    marked[pointer] = "MARK";
    std::string broken = marked.dump();
    const std::string member = Json(pointer.back()).dump() + ":" + value;
    const std::size_t mark = broken.find("\"MARK\"");
    broken.replace(mark, 6, value + "," + member);
    const std::vector<std::string> faults = FaultsOf(broken);
    EXPECT_EQ(faults, std::vector<std::string>({"duplicate_key user.json#" + pointer.to_string()}));
  }
}

TEST(CatalogueSchemaTest, SaysWhatWasGivenAndWhatIsLegal) {
  Json broken = Json::parse(LarchFile());
  broken[Pointer("/season_variants/0/foliage")] = 1.5;
  broken[Pointer("/season_variants/1/seasons/0")] = "fall";
  broken[Pointer("/materials/0/color/1")] = "brown";
  broken[Pointer("/models/0")].erase("share");
  const auto catalogue = Catalogue::Extended({{"larch.json", broken.dump()}});
  ASSERT_FALSE(catalogue.ok());
  const std::string& text = catalogue.status().message();
  for (const char* words :
       {"larch.json#/season_variants/0/foliage", "a number in [0, 1], not 1.5",
        "one of spring, summer, autumn, winter, not \"fall\"", "#rrggbb",
        "larch.json#/models/0/share", "is missing; it must be a number in (0, 1000]"}) {
    EXPECT_NE(text.find(words), std::string::npos) << words << " | " << text;
  }
  EXPECT_EQ(catalogue.status().violations().size(), 4u);
}

}  // namespace
}  // namespace latticeworld
