#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tools/run_program.h"

namespace latticeworld {
namespace {

constexpr char kTwoEyes[] = R"({"suites": [{"name": "two eyes", "sensors": [
  {"name": "scan", "rate_hz": 10, "lidar": {"model": "hokuyo utm-30lx"}}]}]})";

class SensorsCommandTest : public ProgramTest {};

TEST_F(SensorsCommandTest, ListsEveryBuiltInSuiteAndLidar) {
  const ProgramRun run = RunProgram({"sensors"});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  for (const char* words : {"none\n", "standard", "lidar hokuyo utm-30lx, 1 x ",
                            "camera 320 x 240: color, depth", "velodyne vlp-16"}) {
    EXPECT_NE(run.out.find(words), std::string::npos) << words << " | " << run.out;
  }
}

TEST_F(SensorsCommandTest, SaysWhatFilesAdd) {
  Write("eyes.json", kTwoEyes);
  const ProgramRun run = RunProgram({"sensors", PathOf("eyes.json")});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  EXPECT_NE(run.out.find("added: two eyes\n"), std::string::npos) << run.out;
}

TEST_F(SensorsCommandTest, NamesEveryFaultOfAFile) {
  auto json = nlohmann::json::parse(kTwoEyes);
  nlohmann::json& sensor = json["suites"][0]["sensors"][0];
  sensor["lidar"]["model"] = "crystal ball";
  Write("eyes.json", json.dump());
  ProgramRun run = RunProgram({"sensors", PathOf("eyes.json")});
  EXPECT_EQ(run.exit_status, 1);
  for (const char* words : {"eyes.json#/suites/0/sensors/0", "crystal ball", "hokuyo utm-30lx"}) {
    EXPECT_NE(run.err.find(words), std::string::npos) << words << " | " << run.err;
  }
  sensor["rate_hz"] = -1;
  sensor["name"] = "not a name";
  Write("eyes.json", json.dump());
  run = RunProgram({"sensors", PathOf("eyes.json")});
  EXPECT_EQ(run.exit_status, 1);
  for (const char* words :
       {"eyes.json#/suites/0/sensors/0/rate_hz", "eyes.json#/suites/0/sensors/0/name"}) {
    EXPECT_NE(run.err.find(words), std::string::npos) << words << " | " << run.err;
  }
  EXPECT_EQ(RunProgram({"sensors", PathOf("nowhere.json")}).exit_status, 1);
}

TEST_F(SensorsCommandTest, PrintsTheSchema) {
  const ProgramRun run = RunProgram({"sensors", "--schema"});
  EXPECT_EQ(run.exit_status, 0);
  EXPECT_TRUE(nlohmann::json::parse(run.out).contains("title"));
}

}  // namespace
}  // namespace latticeworld
