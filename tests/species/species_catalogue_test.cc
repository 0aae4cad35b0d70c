// What users' files do to the catalogue, and what is wrong with them.

#include "latticeworld/species/species_catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace latticeworld {
namespace {

using Json = nlohmann::json;

Json Donkey() {
  return Json::parse(R"({
    "name": "donkey", "category": "horse", "plan": "grazer", "mass_kg": 180, "height_m": 1.4,
    "radius_m": 0.9, "eye_height_m": 1.3, "cruise_mps": 1.2, "top_speed_mps": 6,
    "acceleration_mps2": 3, "turn_rate_radps": 1.8, "max_slope_rad": 0.7, "wade_depth_m": 0.4,
    "drag_area_m2": 0.8, "water_drag_area_m2": 0.8, "density_kgpm3": 980, "field_of_view_rad": 6,
    "sight_m": 60, "hearing_m": 60, "hit_points": 80})");
}

Json Rover() {
  Json rover = Donkey();
  rover["name"] = "rover";
  rover["category"] = "wheeled robot";
  rover["plan"] = "vehicle";
  rover["vehicle"] = Json::parse(R"({
    "drive": "ackermann", "wheel_radius_m": 0.2, "wheel_width_m": 0.1, "wheel_mass_kg": 4,
    "track_m": 0.8, "wheelbase_m": 1.0, "max_torque_nm": 80, "max_steering_rad": 0.5,
    "chassis_length_m": 1.2, "chassis_width_m": 0.6, "ground_clearance_m": 0.2,
    "center_height_m": 0.3})");
  return rover;
}

std::string FileOf(const Json& species) { return Json({{"species", {species}}}).dump(); }

Result<std::shared_ptr<const SpeciesCatalogue>> With(const std::string& text) {
  return SpeciesCatalogue::Extended({{"user.json", text}});
}

// "code pointer" of every violation.
std::vector<std::string> FaultsOf(const std::string& text) {
  const auto catalogue = With(text);
  std::vector<std::string> faults;
  if (catalogue.ok()) return faults;
  EXPECT_EQ(catalogue.status().code(), StatusCode::kInvalidArgument);
  for (const Violation& violation : catalogue.status().violations()) {
    faults.push_back(violation.code + " " + violation.pointer);
    EXPECT_EQ(violation.pointer.substr(0, 10), "user.json#") << violation.message;
  }
  return faults;
}
std::vector<std::string> FaultsOf(const Json& species) { return FaultsOf(FileOf(species)); }

using Faults = std::vector<std::string>;

TEST(SpeciesCatalogueTest, AddsASpecies) {
  const auto catalogue = With(FileOf(Donkey()));
  ASSERT_TRUE(catalogue.ok()) << catalogue.status().ToString();
  const Species* donkey = (*catalogue)->Find("donkey");
  ASSERT_NE(donkey, nullptr);
  EXPECT_EQ(donkey->mass_kg, 180.0);
  EXPECT_EQ(donkey->category, AgentCategory::kHorse);
  EXPECT_EQ((*catalogue)->all().size(), SpeciesCatalogue::BuiltIn()->all().size() + 1);
  EXPECT_EQ((*catalogue)->Of(AgentCategory::kHorse).name, "horse");
}

TEST(SpeciesCatalogueTest, ReplacesASpeciesOfItsCategoryOnly) {
  Json horse = Donkey();
  horse["name"] = "horse";
  const auto catalogue = With(FileOf(horse));
  ASSERT_TRUE(catalogue.ok()) << catalogue.status().ToString();
  EXPECT_EQ((*catalogue)->Of(AgentCategory::kHorse).mass_kg, 180.0);
  EXPECT_EQ(SpeciesCatalogue::BuiltIn()->Of(AgentCategory::kHorse).mass_kg, 450.0);
  Json sheep = Donkey();
  sheep["name"] = "sheep";
  EXPECT_EQ(FaultsOf(sheep), Faults({"unknown_value user.json#/species/0/category"}));
}

TEST(SpeciesCatalogueTest, ReadsAVehicle) {
  const auto catalogue = With(FileOf(Rover()));
  ASSERT_TRUE(catalogue.ok()) << catalogue.status().ToString();
  const Species* rover = (*catalogue)->Find("rover");
  ASSERT_TRUE(rover != nullptr && rover->vehicle);
  EXPECT_EQ(rover->vehicle->drive, DriveKind::kAckermann);
  EXPECT_EQ(rover->vehicle->wheelbase_m, 1.0);
  EXPECT_EQ(rover->vehicle->spring_npm, 0.0);
}

TEST(SpeciesCatalogueTest, NamesEveryFaultAtOnce) {
  Json donkey = Donkey();
  donkey["mass_kg"] = -3;
  donkey["colour"] = "grey";
  donkey.erase("sight_m");
  donkey["plan"] = "centipede";
  Faults faults = FaultsOf(donkey);
  std::sort(faults.begin(), faults.end());
  EXPECT_EQ(faults, Faults({"missing_key user.json#/species/0/sight_m",
                            "out_of_range user.json#/species/0/mass_kg",
                            "unknown_key user.json#/species/0/colour",
                            "unknown_value user.json#/species/0/plan"}));
}

TEST(SpeciesCatalogueTest, ChecksWhatASchemaCannotSay) {
  const auto broken = [](Json species, const char* key, const Json& value) {
    species[Json::json_pointer(key)] = value;
    return FaultsOf(species);
  };
  const std::string at = " user.json#/species/0";
  EXPECT_EQ(broken(Donkey(), "/cruise_mps", 7), Faults({"out_of_range" + at + "/cruise_mps"}));
  EXPECT_EQ(broken(Donkey(), "/eye_height_m", 2), Faults({"out_of_range" + at + "/eye_height_m"}));
  EXPECT_EQ(broken(Donkey(), "/attack_damage", 2),
            Faults({"out_of_range" + at + "/attack_damage"}));
  EXPECT_EQ(broken(Donkey(), "/plan", "flyer"),
            Faults({"unknown_value" + at + "/plan", "out_of_range" + at + "/altitude_m"}));
  EXPECT_EQ(broken(Donkey(), "/plan", "quadruped"), Faults({"missing_key" + at + "/quadruped"}));
  EXPECT_EQ(broken(Donkey(), "/vehicle", Rover()["vehicle"])[0], "unknown_key" + at + "/vehicle");
  EXPECT_EQ(broken(Rover(), "/vehicle/wheel_mass_kg", 40),
            Faults({"out_of_range" + at + "/vehicle/wheel_mass_kg"}));
  EXPECT_EQ(broken(Rover(), "/vehicle/spring_npm", 4000),
            Faults({"out_of_range" + at + "/vehicle/damper_nspm",
                    "out_of_range" + at + "/vehicle/travel_m"}));
  EXPECT_EQ(broken(Rover(), "/vehicle/drive", "skid_steer"),
            Faults({"out_of_range" + at + "/vehicle/max_steering_rad"}));
  EXPECT_EQ(broken(Rover(), "/radius_m", 0.5), Faults({"out_of_range" + at + "/radius_m"}));
  // Half the track is 0.4, the wheelbase 1: at 1.16 rad the radius of the turn is 0.44.
  EXPECT_EQ(broken(Rover(), "/vehicle/max_steering_rad", 1.16),
            Faults({"out_of_range" + at + "/vehicle/max_steering_rad"}));
  EXPECT_EQ(broken(Donkey(), "/knock_over_mps", 2),
            Faults({"out_of_range" + at + "/knock_over_mps"}));
  // It wades 0.4 m deep.
  EXPECT_EQ(broken(Donkey(), "/drowning_depth_m", 0.3),
            Faults({"out_of_range" + at + "/wade_depth_m"}));
  EXPECT_EQ(broken(Donkey(), "/radius_m", 6), Faults({"out_of_range" + at + "/radius_m"}));
}

TEST(SpeciesCatalogueTest, AVehiclesRadiusHoldsItsWheelsHoweverTheySteer) {
  const auto with = [](double radius_m) {
    Json rover = Rover();
    rover["radius_m"] = radius_m;
    return FaultsOf(rover);
  };
  // The front wheels' middles are at 0.640, and the wheels reach 0.206 from there.
  EXPECT_EQ(with(0.85), Faults());
  EXPECT_EQ(with(0.84), Faults({"out_of_range user.json#/species/0/radius_m"}));
}

TEST(SpeciesCatalogueTest, AQuadrupedsRadiusHoldsItsFeet) {
  const auto with = [](double radius_m) {
    Json dog = Donkey();
    dog["plan"] = "quadruped";
    dog["category"] = "robotic dog";
    dog["mass_kg"] = 32;
    dog["radius_m"] = radius_m;
    dog["quadruped"] = Json::parse(R"({
      "hip_x_m": 0.2, "hip_y_m": 0.1, "abductor_m": 0.2, "thigh_m": 0.25, "shank_m": 0.25,
      "foot_radius_m": 0.025, "leg_mass_kg": 2, "stance_height_m": 0.36, "swing_height_m": 0.07,
      "stride_period_s": 0.5, "max_effort_nm": 60, "max_rate_radps": 20, "trunk_length_m": 0.4,
      "trunk_width_m": 0.25, "trunk_height_m": 0.15})");
    return FaultsOf(dog);
  };
  EXPECT_EQ(with(0.37), Faults());  // the feet are at 0.36
  EXPECT_EQ(with(0.35), Faults({"out_of_range user.json#/species/0/radius_m"}));
}

TEST(SpeciesCatalogueTest, RefusesANameTwice) {
  EXPECT_EQ(FaultsOf(Json({{"species", {Donkey(), Donkey()}}}).dump()),
            Faults({"duplicate_value user.json#/species/1/name"}));
}

TEST(SpeciesCatalogueTest, RefusesHostileTexts) {
  EXPECT_EQ(FaultsOf(std::string()), Faults({"parse_error user.json#"}));
  EXPECT_EQ(FaultsOf(std::string("{\"species\": [")), Faults({"parse_error user.json#"}));
  EXPECT_FALSE(FaultsOf(std::string("[]")).empty());
  EXPECT_FALSE(FaultsOf(std::string("{\"species\": []}")).empty());
  EXPECT_FALSE(FaultsOf(std::string("{\"species\": [1e999]}")).empty());
  EXPECT_FALSE(FaultsOf(std::string(5000, '[')).empty());
  for (const char* name : {"", "Donkey", "don key ", "don  key", "don_key", "a\nb"}) {
    Json donkey = Donkey();
    donkey["name"] = name;
    EXPECT_EQ(FaultsOf(donkey), Faults({"bad_format user.json#/species/0/name"})) << name;
  }
}

class SpeciesFilesTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() /
        (std::string("species_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void Write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
  }
  std::filesystem::path folder_;
};

TEST_F(SpeciesFilesTest, LoadsAFileOrAFolder) {
  Write("donkey.json", FileOf(Donkey()));
  Write("rover.json", FileOf(Rover()));
  Write("notes.txt", "not a species");
  const auto one = SpeciesCatalogue::Load(folder_ / "donkey.json");
  ASSERT_TRUE(one.ok()) << one.status().ToString();
  EXPECT_EQ((*one)->Find("rover"), nullptr);
  const auto all = SpeciesCatalogue::Load(folder_);
  ASSERT_TRUE(all.ok()) << all.status().ToString();
  EXPECT_NE((*all)->Find("donkey"), nullptr);
  EXPECT_NE((*all)->Find("rover"), nullptr);
}

TEST_F(SpeciesFilesTest, SaysWhatIsNotThere) {
  EXPECT_EQ(SpeciesCatalogue::Load(folder_ / "none.json").status().code(), StatusCode::kNotFound);
  EXPECT_EQ(SpeciesCatalogue::Load(folder_).status().code(), StatusCode::kNotFound);
}

}  // namespace
}  // namespace latticeworld
