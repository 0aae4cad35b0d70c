// The schema accepts what ships and refuses a file with any one field broken.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {

std::string_view SpeciesData(std::string_view file_name);  // embedded

namespace {

using Json = nlohmann::ordered_json;
using Pointer = Json::json_pointer;

constexpr const char* kFiles[] = {"animals.json", "characters.json", "robots.json",
                                  "vehicles.json"};

std::vector<std::string> FaultsOf(const std::string& text) {
  std::vector<std::string> faults;
  const auto catalogue = SpeciesCatalogue::Extended({{"user.json", text}});
  if (catalogue.ok()) return faults;
  for (const Violation& violation : catalogue.status().violations()) {
    faults.push_back(violation.code + " " + violation.pointer);
  }
  return faults;
}

std::string NamesIn(const Json& names) {
  std::string all;
  for (const Json& name : names) all += (all.empty() ? "" : ", ") + name.get<std::string>();
  return all;
}

void Collect(const Json& json, const Pointer& at, std::vector<Pointer>* pointers) {
  if (!at.empty()) pointers->push_back(at);
  if (!json.is_structured()) return;
  for (const auto& [key, value] : json.items()) {
    Collect(value, json.is_array() ? at / std::stoul(key) : at / key, pointers);
  }
}

TEST(SpeciesSchemaTest, KnowsTheNamesThatTheCodeKnows) {
  const Json schema = Json::parse(SpeciesCatalogue::schema());
  EXPECT_EQ(schema.at("$schema"), "http://json-schema.org/draft-07/schema#");
  const std::string species = "/definitions/species/properties/";
  EXPECT_EQ(NamesIn(schema.at(Pointer(species + "category/enum"))), LegalNames<AgentCategory>());
  EXPECT_EQ(NamesIn(schema.at(Pointer(species + "plan/enum"))), LegalNames<BodyPlan>());
  EXPECT_EQ(NamesIn(schema.at(Pointer("/definitions/vehicle/properties/drive/enum"))),
            LegalNames<DriveKind>());
}

TEST(SpeciesSchemaTest, AcceptsEveryShippedFileAsAUsersFile) {
  for (const char* name : kFiles) {
    EXPECT_EQ(FaultsOf(std::string(SpeciesData(name))), std::vector<std::string>()) << name;
  }
}

TEST(SpeciesSchemaTest, RefusesEveryValueOfTheWrongTypeAndEveryNumberOutOfRange) {
  int numbers = 0;
  for (const char* name : {"robots.json", "vehicles.json"}) {
    const Json whole = Json::parse(SpeciesData(name));
    // One file of each species, so that the cost stays small.
    for (const Json& species : whole.at("species")) {
      const Json file = {{"species", Json::array({species})}};
      std::vector<Pointer> pointers;
      Collect(file, Pointer(), &pointers);
      for (const Pointer& pointer : pointers) {
        const auto expect = [&](const Json& wrong, const std::string& code) {
          Json broken = file;
          broken[pointer] = wrong;
          const std::vector<std::string> faults = FaultsOf(broken.dump());
          const std::string fault = code + " user.json#" + pointer.to_string();
          EXPECT_NE(std::find(faults.begin(), faults.end(), fault), faults.end()) << fault;
        };
        expect(nullptr, "wrong_type");
        if (!file.at(pointer).is_number()) continue;
        expect("1", "wrong_type");
        expect(-1e6, "out_of_range");
        expect(1e9, "out_of_range");
        ++numbers;
      }
    }
  }
  EXPECT_GT(numbers, 150);
}

}  // namespace
}  // namespace latticeworld
