#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tools/run_program.h"

namespace latticeworld {
namespace {

constexpr char kDonkey[] = R"({"species": [{
  "name": "donkey", "category": "horse", "plan": "grazer", "mass_kg": 180, "height_m": 1.4,
  "radius_m": 0.9, "eye_height_m": 1.3, "cruise_mps": 1.2, "top_speed_mps": 6,
  "acceleration_mps2": 3, "turn_rate_radps": 1.8, "max_slope_rad": 0.7, "wade_depth_m": 0.4,
  "drag_area_m2": 0.8, "water_drag_area_m2": 0.8, "density_kgpm3": 980, "field_of_view_rad": 6,
  "sight_m": 60, "hearing_m": 60, "hit_points": 80}]})";

class SpeciesCommandTest : public ProgramTest {};

TEST_F(SpeciesCommandTest, ListsEveryBuiltInSpecies) {
  const ProgramRun run = RunProgram({"species"});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  for (const char* words : {"ackermann car       wheeled robot    ackermann     300    10",
                            "robotic dog         robotic dog      quadruped      32   1.5",
                            "whale               whale            swimmer"}) {
    EXPECT_NE(run.out.find(words), std::string::npos) << words << " | " << run.out;
  }
}

TEST_F(SpeciesCommandTest, SaysWhatFilesAdd) {
  Write("donkey.json", kDonkey);
  const ProgramRun run = RunProgram({"species", PathOf("donkey.json")});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  EXPECT_NE(run.out.find("added: donkey\n"), std::string::npos) << run.out;
}

TEST_F(SpeciesCommandTest, NamesEveryFaultOfAFile) {
  auto json = nlohmann::json::parse(kDonkey);
  json["species"][0]["mass_kg"] = -1;
  json["species"][0].erase("sight_m");
  Write("donkey.json", json.dump());
  const ProgramRun run = RunProgram({"species", PathOf("donkey.json")});
  EXPECT_EQ(run.exit_status, 1);
  for (const char* words :
       {"donkey.json#/species/0/mass_kg", "[0.1, 1e+05]", "donkey.json#/species/0/sight_m"}) {
    EXPECT_NE(run.err.find(words), std::string::npos) << words << " | " << run.err;
  }
  EXPECT_EQ(RunProgram({"species", PathOf("nowhere.json")}).exit_status, 1);
}

TEST_F(SpeciesCommandTest, PrintsTheSchema) {
  const ProgramRun run = RunProgram({"species", "--schema"});
  EXPECT_EQ(run.exit_status, 0);
  EXPECT_EQ(nlohmann::json::parse(run.out).at("title"), "LatticeWorld species file");
}

}  // namespace
}  // namespace latticeworld
