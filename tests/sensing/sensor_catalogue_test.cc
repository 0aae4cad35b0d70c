// The suites that ship, what users' files do to them, and what is wrong with such files.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "latticeworld/sensing/sensor_suite.h"

namespace latticeworld {

std::string_view SensorData(std::string_view file_name);  // embedded

namespace {

using Json = nlohmann::ordered_json;
using Pointer = Json::json_pointer;

const SensorCatalogue& BuiltIn() { return *SensorCatalogue::BuiltIn(); }

const SensorSpec* FindSensor(const SensorSuite& suite, const std::string& name) {
  for (const SensorSpec& sensor : suite.sensors) {
    if (sensor.name == name) return &sensor;
  }
  return nullptr;
}

std::vector<std::string> FaultsOf(const std::string& text) {
  std::vector<std::string> faults;
  const auto catalogue = SensorCatalogue::Extended({{"user.json", text}});
  if (catalogue.ok()) return faults;
  EXPECT_EQ(catalogue.status().code(), StatusCode::kInvalidArgument);
  for (const Violation& violation : catalogue.status().violations()) {
    faults.push_back(violation.code + " " + violation.pointer);
  }
  return faults;
}
using Faults = std::vector<std::string>;

std::string SuiteOf(const std::string& sensors) {
  return R"({"suites": [{"name": "mine", "sensors": [)" + sensors + "]}]}";
}

TEST(BuiltInSensorsTest, AreSortedAndFoundByTheirNames) {
  for (const char* name :
       {"none", "scanner", "standard", "survey", "velodyne", "perception", "aerial"}) {
    ASSERT_NE(BuiltIn().FindSuite(name), nullptr) << name;
  }
  for (const char* name :
       {"hokuyo urg-04lx", "hokuyo utm-30lx", "sick lms111", "rplidar a2", "velodyne vlp-16",
        "velodyne hdl-32e", "velodyne hdl-64e", "ouster os1-64", "ouster os1-128"}) {
    ASSERT_NE(BuiltIn().FindLidar(name), nullptr) << name;
  }
  EXPECT_EQ(BuiltIn().FindSuite("unicorn"), nullptr);
  EXPECT_EQ(BuiltIn().FindLidar(""), nullptr);
  const auto by_name = [](const auto& a, const auto& b) { return a.name < b.name; };
  EXPECT_TRUE(std::is_sorted(BuiltIn().suites().begin(), BuiltIn().suites().end(), by_name));
  EXPECT_TRUE(std::is_sorted(BuiltIn().lidars().begin(), BuiltIn().lidars().end(), by_name));
  for (const SensorSuite& suite : BuiltIn().suites()) {
    EXPECT_TRUE(std::is_sorted(suite.sensors.begin(), suite.sensors.end(), by_name));
  }
}

TEST(BuiltInSensorsTest, SuitesCarryWhatTheyPromise) {
  EXPECT_TRUE(BuiltIn().FindSuite("none")->sensors.empty());
  const SensorSuite& standard = *BuiltIn().FindSuite("standard");
  const auto model = [&](const char* name) { return FindSensor(standard, name)->model.index(); };
  EXPECT_EQ(standard.sensors.size(), 7u);
  EXPECT_EQ(model("scan"), 0u);
  EXPECT_EQ(model("camera"), 1u);
  EXPECT_EQ(model("imu"), 2u);
  EXPECT_EQ(model("fix"), 3u);
  EXPECT_EQ(model("magnetic_field"), 4u);
  EXPECT_EQ(model("wheel_odom"), 5u);
  EXPECT_EQ(model("bumper"), 6u);
  // What extends a suite has all of it, and its own in the place of others of their name.
  const SensorSuite& perception = *BuiltIn().FindSuite("perception");
  EXPECT_EQ(perception.sensors.size(), 8u);
  EXPECT_TRUE(std::get<CameraSensor>(FindSensor(perception, "camera")->model).outputs.class_labels);
  const auto& points = std::get<LidarModel>(FindSensor(perception, "points")->model);
  EXPECT_EQ(points.name, "ouster os1-64");
  EXPECT_EQ(points.ring_elevations_rad.size() * points.columns, 64u * 1024u);
}

TEST(BuiltInSensorsTest, LidarsLookWhereTheirDataSheetsSay) {
  const LidarModel& puck = *BuiltIn().FindLidar("velodyne vlp-16");
  ASSERT_EQ(puck.ring_elevations_rad.size(), 16u);
  EXPECT_NEAR(puck.ring_elevations_rad[0], -15.0 * M_PI / 180.0, 1e-12);
  EXPECT_NEAR(puck.ring_elevations_rad[8], 1.0 * M_PI / 180.0, 1e-12);
  EXPECT_FALSE(puck.source.empty());
  const LidarModel& scanner = *BuiltIn().FindLidar("hokuyo utm-30lx");
  EXPECT_EQ(scanner.ring_elevations_rad, std::vector<double>{0.0});
  const double step_rad = scanner.field_of_view_rad / scanner.columns;
  EXPECT_NEAR(step_rad, 0.25 * M_PI / 180.0, 1e-12);
  EXPECT_NEAR(scanner.first_azimuth_rad + 540 * step_rad, 0.0, 1e-12);  // beam 540 straight ahead
  EXPECT_EQ(BuiltIn().FindLidar("velodyne hdl-64e")->ring_elevations_rad.size(), 64u);
  EXPECT_EQ(BuiltIn().FindLidar("ouster os1-128")->ring_azimuths_rad.size(), 128u);
}

TEST(SensorCatalogueTest, AUsersEntryIsAddedOrTakesThePlaceOfAnother) {
  const auto catalogue = SensorCatalogue::Extended(
      {{"a.json", R"({"lidars": [{"name": "mine", "source": "me", "columns": 36,
          "min_range_m": 0.1, "max_range_m": 5, "noise_m": 0.01}]})"},
       {"b.json", R"({"suites": [
          {"name": "standard", "sensors": []},
          {"name": "mine", "extends": "standard", "sensors": [{"name": "scan", "rate_hz": 5,
           "position_m": [1, 2, 3], "on_top": true, "roll_pitch_yaw_deg": [0, 90, 0],
           "lidar": {"model": "mine", "columns": 72}}]}]})"}});
  ASSERT_TRUE(catalogue.ok()) << catalogue.status().ToString();
  EXPECT_TRUE((*catalogue)->FindSuite("standard")->sensors.empty());
  const SensorSuite& mine = *(*catalogue)->FindSuite("mine");
  ASSERT_EQ(mine.sensors.size(), 1u);
  const auto& lidar = std::get<LidarModel>(mine.sensors[0].model);
  EXPECT_EQ(lidar.name, "mine");
  EXPECT_EQ(lidar.columns, 72);
  EXPECT_EQ((*catalogue)->FindLidar("mine")->columns, 36);
  const Eigen::Isometry3d base_from_sensor = BaseFromSensor(mine.sensors[0], 0.5);
  EXPECT_TRUE(base_from_sensor.translation().isApprox(Eigen::Vector3d(1.0, 2.0, 3.5)));
  // Pitched by 90 degrees it looks straight down.
  EXPECT_TRUE((base_from_sensor.linear() * Eigen::Vector3d::UnitX())
                  .isApprox(-Eigen::Vector3d::UnitZ(), 1e-12));
}

TEST(SensorCatalogueTest, EveryFaultIsNamedWithItsPlace) {
  EXPECT_EQ(FaultsOf("{"), Faults{"parse_error user.json#"});
  EXPECT_EQ(FaultsOf("{}"), Faults{"wrong_count user.json#"});
  EXPECT_EQ(FaultsOf(R"({"robots": []})")[0], "unknown_key user.json#/robots");
  const std::string at = "user.json#/suites/0/sensors/0";
  EXPECT_EQ(FaultsOf(SuiteOf(R"({"name": "a", "rate_hz": 1})")), Faults{"wrong_count " + at});
  EXPECT_EQ(FaultsOf(SuiteOf(R"({"name": "a", "rate_hz": 1, "imu": {}, "gnss": {}})")),
            Faults{"wrong_count " + at});
  EXPECT_EQ(FaultsOf(SuiteOf(R"({"name": "odom", "rate_hz": 1, "imu": {}})")),
            Faults{"unknown_value " + at + "/name"});
  EXPECT_EQ(FaultsOf(SuiteOf(R"({"name": "a", "rate_hz": 1, "lidar": {"model": "laser"}})")),
            Faults{"unknown_value " + at + "/lidar/model"});
  EXPECT_EQ(FaultsOf(SuiteOf(R"({"name": "a", "rate_hz": 1,
                "lidar": {"model": "ouster os1-128", "columns": 65536}})")),
            Faults{"out_of_range " + at + "/lidar/columns"});
  EXPECT_EQ(FaultsOf(SuiteOf(R"({"name": "a", "rate_hz": 0.1,
                "lidar": {"model": "ouster os1-128"}})")),
            Faults{"out_of_range " + at + "/rate_hz"});
  EXPECT_EQ(FaultsOf(SuiteOf(R"({"name": "a", "rate_hz": 1, "imu": {}},
                                {"name": "a", "rate_hz": 2, "gnss": {}})")),
            Faults{"duplicate_value user.json#/suites/0/sensors/1/name"});
  const std::string camera = R"({"name": "a", "rate_hz": 1, "camera": {"outputs": ["depth"],
      "width": 320, "height": 240, "fx_px": 277, "fy_px": 277, "cx_px": 159.5, "cy_px": 119.5, )";
  EXPECT_EQ(FaultsOf(SuiteOf(camera + R"("near_m": 5, "far_m": 2}})")),
            Faults{"out_of_range " + at + "/camera/near_m"});
  EXPECT_EQ(FaultsOf(SuiteOf(camera + R"("distortion": [-1, 0, 0, 0, 0]}})")),
            Faults{"out_of_range " + at + "/camera/distortion"});
  EXPECT_EQ(FaultsOf(SuiteOf(camera + R"("distortion": [-0.2, 0, 0, 0, 0]}})")), Faults{});
}

TEST(SensorCatalogueTest, ManyFaultsAreToldAtOnce) {
  const Faults faults = FaultsOf(SuiteOf(R"(
      {"name": "a", "rate_hz": 0, "imu": {"max_rate_radps": -1}},
      {"name": "B", "rate_hz": 1, "bumper": {"threshold_n": "5"}},
      {"name": "c", "rate_hz": 1e9, "gnss": {"canopy_factor": 0.5}})"));
  const std::set<std::string> told(faults.begin(), faults.end());
  const std::string at = "user.json#/suites/0/sensors/";
  for (const char* fault : {"out_of_range 0/rate_hz", "out_of_range 0/imu/max_rate_radps",
                            "bad_format 1/name", "wrong_type 1/bumper/threshold_n",
                            "out_of_range 2/rate_hz", "out_of_range 2/gnss/canopy_factor"}) {
    const std::string text = fault;
    const std::size_t space = text.find(' ') + 1;
    EXPECT_EQ(told.count(text.substr(0, space) + at + text.substr(space)), 1u) << fault;
  }
  EXPECT_EQ(faults.size(), 6u);
}

TEST(SensorCatalogueTest, LidarsThatCannotBeAreRefused) {
  const auto lidar = [](const std::string& more) {
    return R"({"lidars": [{"name": "mine", "source": "me", "columns": 36, "noise_m": 0,)" + more +
           "}]}";
  };
  const std::string ranges = R"("min_range_m": 0.1, "max_range_m": 5)";
  EXPECT_EQ(FaultsOf(lidar(ranges)), Faults{});
  EXPECT_EQ(FaultsOf(lidar(R"("min_range_m": 6, "max_range_m": 5)")),
            Faults{"out_of_range user.json#/lidars/0/min_range_m"});
  EXPECT_EQ(FaultsOf(lidar(ranges + R"(, "ring_elevations_deg": [1, 0])")),
            Faults{"out_of_range user.json#/lidars/0"});
  EXPECT_EQ(FaultsOf(lidar(ranges + R"(, "ring_elevations_deg": [0, 1], "evenly_spaced_rings":
                {"count": 2, "lowest_deg": 0, "highest_deg": 1})")),
            Faults{"wrong_count user.json#/lidars/0"});
}

TEST(SensorCatalogueTest, SuitesThatExtendWhatIsNotThereOrThemselvesAreRefused) {
  EXPECT_EQ(FaultsOf(R"({"suites": [{"name": "a", "extends": "b", "sensors": []}]})"),
            Faults{"unknown_value user.json#/suites/0/extends"});
  EXPECT_EQ(FaultsOf(R"({"suites": [{"name": "a", "extends": "a", "sensors": []}]})"),
            Faults{"unknown_value user.json#/suites/0/extends"});
  const Faults faults = FaultsOf(R"({"suites": [{"name": "a", "extends": "b", "sensors": []},
                                               {"name": "b", "extends": "a", "sensors": []}]})");
  EXPECT_EQ(faults, (Faults{"unknown_value user.json#/suites/0/extends",
                            "unknown_value user.json#/suites/1/extends"}));
}

TEST(SensorCatalogueTest, FilesAndFoldersAreLoaded) {
  namespace fs = std::filesystem;
  const fs::path folder =
      fs::path(testing::TempDir()) / ("latticeworld_sensors_" + std::to_string(getpid()));
  fs::remove_all(folder);
  fs::create_directory(folder);
  EXPECT_EQ(SensorCatalogue::Load({folder}).status().code(), StatusCode::kNotFound);
  EXPECT_EQ(SensorCatalogue::Load({folder / "no.json"}).status().code(), StatusCode::kNotFound);
  std::ofstream(folder / "my.json") << SuiteOf(R"({"name": "imu", "rate_hz": 10, "imu": {}})");
  const auto catalogue = SensorCatalogue::Load({folder});
  ASSERT_TRUE(catalogue.ok()) << catalogue.status().ToString();
  EXPECT_NE((*catalogue)->FindSuite("mine"), nullptr);
  fs::remove_all(folder);
}

// Changes every value of what ships, one at a time.
TEST(SensorSchemaTest, RefusesEveryValueOfTheWrongTypeAndEveryNumberOutOfRange) {
  int numbers = 0;
  const std::function<void(const Json&, const Pointer&, const Json&)> visit =
      [&](const Json& json, const Pointer& at, const Json& file) {
        const auto expect = [&](const Json& wrong, const std::string& code) {
          Json broken = file;
          broken[at] = wrong;
          const Faults faults = FaultsOf(broken.dump());
          const std::string fault = code + " user.json#" + at.to_string();
          EXPECT_NE(std::find(faults.begin(), faults.end(), fault), faults.end()) << fault;
        };
        if (!at.empty()) expect(nullptr, "wrong_type");
        if (json.is_number()) {
          expect("1", "wrong_type");
          expect(json.is_number_integer() ? Json(-1000000000) : Json(-1e9), "out_of_range");
          expect(json.is_number_integer() ? Json(1000000000) : Json(1e9), "out_of_range");
          ++numbers;
        }
        if (!json.is_structured()) return;
        for (const auto& [key, value] : json.items()) {
          visit(value, json.is_array() ? at / std::stoul(key) : at / key, file);
        }
      };
  // One of a kind of each, so that the cost stays small.
  const Json suites = Json::parse(SensorData("suites.json"));
  for (const char* name : {"scanner", "standard"}) {
    for (const Json& suite : suites.at("suites")) {
      if (suite.at("name") == name) visit({{"suites", {suite}}}, Pointer(), {{"suites", {suite}}});
    }
  }
  const Json lidars = Json::parse(SensorData("lidars.json"));
  const Json puck = {{"lidars", {lidars.at("lidars").at(4)}}};
  visit(puck, Pointer(), puck);
  EXPECT_GT(numbers, 60);
}

}  // namespace
}  // namespace latticeworld
