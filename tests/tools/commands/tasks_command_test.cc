#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "latticeworld/species/species_catalogue.h"
#include "tools/run_program.h"

namespace latticeworld {
namespace {

class TasksCommandTest : public ProgramTest {
 protected:
  void MakeWorld() {
    const ProgramRun run =
        RunProgram({"generate", "--layout", "A lake in the center, forest around it.", "--seed",
                    "5", "--size", "128", "--resolution", "1", "--out", PathOf("lake")});
    ASSERT_EQ(run.exit_status, 0) << run.err;
  }
};

TEST_F(TasksCommandTest, WritesTasksOfTheAskedDifficultyThatRepeat) {
  MakeWorld();
  const std::vector<std::string> arguments = {
      "tasks", PathOf("lake"), "--count", "4",     "--seed",
      "9",     "--length",     "30,60",   "--out", PathOf("tasks.json")};
  const ProgramRun run = RunProgram(arguments);
  ASSERT_EQ(run.exit_status, 0) << run.err;
  EXPECT_NE(run.out.find("length m"), std::string::npos);
  const std::string text = Read("tasks.json");
  const auto json = nlohmann::json::parse(text);
  ASSERT_EQ(json.at("tasks").size(), 4u);
  for (const auto& task : json.at("tasks")) {
    EXPECT_GE(task.at("length_m"), 30.0);
    EXPECT_LE(task.at("length_m"), 60.0);
  }
  ASSERT_EQ(RunProgram(arguments).exit_status, 0);
  EXPECT_EQ(Read("tasks.json"), text);
}

TEST_F(TasksCommandTest, DrawsTheWaysOnTheMapWhereAskedTo) {
  MakeWorld();
  const ProgramRun run =
      RunProgram({"tasks", PathOf("lake"), "--count", "2", "--length", "30,60", "--out",
                  PathOf("tasks.json"), "--picture", PathOf("tasks.png")});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  EXPECT_EQ(Read("tasks.png").rfind("\x89PNG", 0), 0u);
  const ProgramRun nowhere =
      RunProgram({"tasks", PathOf("lake"), "--count", "1", "--out", PathOf("tasks.json"),
                  "--picture", PathOf("no/such/folder.png")});
  EXPECT_EQ(nowhere.exit_status, 1);
  EXPECT_NE(nowhere.err.find("--picture"), std::string::npos) << nowhere.err;
}

TEST_F(TasksCommandTest, TheRadiusIsThatOfTheSpeciesUnlessItIsSaid) {
  MakeWorld();
  const auto radius_m = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments = {"tasks", PathOf("lake"), "--count",
                                          "1",     "--out",        PathOf("tasks.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramRun run = RunProgram(arguments);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    return nlohmann::json::parse(Read("tasks.json")).at("robot").at("radius_m").get<double>();
  };
  const SpeciesCatalogue& catalogue = *SpeciesCatalogue::BuiltIn();
  EXPECT_EQ(radius_m({}), catalogue.Find("wheeled robot")->radius_m);
  EXPECT_EQ(radius_m({"--robot-species", "tractor"}), catalogue.Find("tractor")->radius_m);
  EXPECT_EQ(radius_m({"--robot-species", "tractor", "--robot-radius", "0.5"}), 0.5);
  const ProgramRun unknown = RunProgram(
      {"tasks", PathOf("lake"), "--robot-species", "dragon", "--out", PathOf("tasks.json")});
  EXPECT_EQ(unknown.exit_status, 2);
  EXPECT_NE(unknown.err.find("dragon"), std::string::npos) << unknown.err;
}

TEST_F(TasksCommandTest, SaysWhatIsUnusableAndWhatTheWorldHasNot) {
  MakeWorld();
  const ProgramRun unusable = RunProgram(
      {"tasks", PathOf("lake"), "--robot-radius", "-1", "--robot-mass", "1e9", "--robot-grip", "0",
       "--seed", "x", "--count", "0", "--climb", "9,1", "--out", PathOf("tasks.json")});
  EXPECT_EQ(unusable.exit_status, 2);
  for (const char* name :
       {"--robot-radius", "--robot-mass", "--robot-grip", "--seed", "--count", "--climb"})
    EXPECT_NE(unusable.err.find(name), std::string::npos) << unusable.err;
  const ProgramRun missing = RunProgram({"tasks", PathOf("lake"), "--climb", "900,1000", "--count",
                                         "1", "--out", PathOf("tasks.json")});
  EXPECT_EQ(missing.exit_status, 1);
  EXPECT_NE(missing.err.find("climb_m was outside [900, 1000]"), std::string::npos) << missing.err;
  EXPECT_EQ(Entries(), std::vector<std::string>{"lake"});
}

}  // namespace
}  // namespace latticeworld
