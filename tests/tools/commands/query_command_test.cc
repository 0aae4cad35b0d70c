#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tools/run_program.h"

namespace latticeworld {
namespace {

class QueryCommandTest : public ProgramTest {
 protected:
  void Generate() {
    Write("things.json", R"([{"kind": "bench", "name": "seat", "x": 3, "y": -8, "yaw_deg": 90},
                             {"kind": "crate", "name": "box"}])");
    const ProgramRun run =
        RunProgram({"generate", "--layout", "Grassland.", "--size", "64", "--seed", "1", "--things",
                    PathOf("things.json"), "--out", PathOf("world")});
    ASSERT_EQ(run.exit_status, 0) << run.err;
  }
};

TEST_F(QueryCommandTest, AThingsNameAnswersWithItsPoseKindAndSize) {
  Generate();
  const ProgramRun run = RunProgram({"query", PathOf("world"), "box", "seat", "--json"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  const auto things = nlohmann::json::parse(run.out);
  ASSERT_EQ(things.size(), 2u);
  EXPECT_EQ(things[0]["kind"], "crate");
  EXPECT_EQ(things[0]["model"], "");
  EXPECT_NEAR(things[0]["height_m"].get<double>(), 0.6, 0.3);
  EXPECT_EQ(things[1]["kind"], "bench");
  EXPECT_NEAR(things[1]["x_m"].get<double>(), 3.0, 1e-4);
  EXPECT_NEAR(things[1]["y_m"].get<double>(), -8.0, 1e-4);
  EXPECT_NEAR(things[1]["yaw_deg"].get<double>(), 90.0, 1e-3);
  EXPECT_GT(things[1]["width_m"], things[1]["length_m"]);  // one sits along it
  const ProgramRun all = RunProgram({"query", PathOf("world")});
  EXPECT_EQ(all.exit_status, 0);
  EXPECT_NE(all.out.find("seat"), std::string::npos) << all.out;
}

TEST_F(QueryCommandTest, AnUnknownNameIsAFailureThatTellsTheKnownOnes) {
  Generate();
  const ProgramRun run = RunProgram({"query", PathOf("world"), "seet"});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_NE(run.err.find("\"seet\""), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("seat"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace latticeworld
