#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/run_program.h"

namespace latticeworld {
namespace {

using Json = nlohmann::json;

// A grey picture of a slope that rises from west to east by the whole of the grey values, with 16
// bits.
std::string SlopePgm(int cols, int rows) {
  std::string pgm = "P5\n" + std::to_string(cols) + " " + std::to_string(rows) + "\n65535\n";
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      const int value = static_cast<int>(std::lround(65535.0 * c / (cols - 1)));
      pgm.push_back(static_cast<char>(value >> 8));
      pgm.push_back(static_cast<char>(value & 255));
    }
  }
  return pgm;
}

// Hills of elevation on a grid of 70 x 65 samples of 10 m.
std::string HillsAsc(double amplitude_m) {
  std::string file =
      "ncols 70\nnrows 65\nxllcorner 0\nyllcorner 0\ncellsize 10\nNODATA_value -9999\n";
  for (int r = 0; r < 65; ++r) {
    for (int c = 0; c < 70; ++c) {
      file += std::to_string(500.0 + amplitude_m * std::sin(0.31 * c) * std::cos(0.23 * r)) + " ";
    }
    file += "\n";
  }
  return file;
}

class MeasureCommandTest : public ProgramTest {
 protected:
  void ExpectFailure(int exit_status, const std::vector<std::string>& arguments,
                     const std::vector<std::string>& words) {
    const ProgramRun run = RunProgram(arguments);
    EXPECT_EQ(run.exit_status, exit_status) << run.err;
    EXPECT_EQ(run.out, "");
    for (const std::string& word : words) {
      EXPECT_NE(run.err.find(word), std::string::npos) << word << " | " << run.err;
    }
  }

  Json Measured(const std::vector<std::string>& paths) {
    std::vector<std::string> arguments = {"measure", "--json"};
    arguments.insert(arguments.end(), paths.begin(), paths.end());
    const ProgramRun run = RunProgram(arguments);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    return Json::parse(run.out, nullptr, false);
  }

  std::string MakeBundle(const std::string& name, const std::string& seed) {
    const ProgramRun run = RunProgram({"generate", "--layout", "A lake in the center. Rocky land.",
                                       "--vocabulary", "wild", "--seed", seed, "--size", "256",
                                       "--resolution", "2", "--out", PathOf(name)});
    EXPECT_EQ(run.exit_status, 0) << run.err;
    return PathOf(name);
  }
};

TEST_F(MeasureCommandTest, SaysOfAHeightMapWhatItsGeometryIs) {
  Write("slope.pgm", SlopePgm(101, 80));
  // 50.5 m in 101 cells of half a metre; from the first to the last centre 50 m, and 20 m up.
  const ProgramRun run = RunProgram(
      {"measure", PathOf("slope.pgm"), "--size", "50.5", "--height-scale", "20", "--json"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  const Json land = Json::parse(run.out)["lands"][0];
  EXPECT_EQ(land["cols"], 101);
  EXPECT_EQ(land["rows"], 80);
  EXPECT_DOUBLE_EQ(land["resolution_m"], 0.5);
  EXPECT_NEAR(land["relief_m"], 20.0, 1e-3);
  EXPECT_NEAR(land["measures"]["mean_slope_deg"]["value"], std::atan(0.4) * 180.0 / M_PI, 0.05);
  EXPECT_EQ(land["measures"]["mean_slope_deg"]["within"], true);
  EXPECT_NEAR(land["measures"]["hypsometric_integral"]["value"], 0.5, 0.01);
  EXPECT_TRUE(land["measures"]["concavity"]["value"].is_null()) << "one slope has no concavity";
  EXPECT_EQ(land["measures"]["concavity"]["within"], false);
}

TEST_F(MeasureCommandTest, MeasuresTheDryLandOfABundle) {
  const Json land = Measured({MakeBundle("lake", "5")})["lands"][0];
  EXPECT_EQ(land["rows"], 128);
  EXPECT_DOUBLE_EQ(land["resolution_m"], 2.0);
  EXPECT_GT(land["dry_share"], 0.5);
  EXPECT_LT(land["dry_share"], 0.99) << "the lake is no land";
  EXPECT_GT(land["relief_m"], 1.0);
  EXPECT_FALSE(land["streams_of_order"].empty());
}

TEST_F(MeasureCommandTest, PrintsOneLandWithNaturesRanges) {
  Write("hills.asc", HillsAsc(16.0));
  const ProgramRun run = RunProgram({"measure", PathOf("hills.asc")});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  for (const char* words :
       {"hills.asc", "70 x 65 cells of 10.0 m", "100.0 % of it dry", "hypsometric integral",
        "0.35 to 0.65", "0.30 to 0.60", "0.45 to 0.62", "3.00 to 5.00", "-4.20 to -3.00",
        "Strahler 1952", "Hack 1957", "Flint 1974", "Horton 1945", "Turcotte 1997", "within"}) {
    EXPECT_NE(run.out.find(words), std::string::npos) << words << " | " << run.out;
  }
}

TEST_F(MeasureCommandTest, PutsSeveralLandsSideBySide) {
  Write("low.asc", HillsAsc(8.0));
  Write("high.asc", HillsAsc(16.0));
  const ProgramRun run =
      RunProgram({"measure", PathOf("low.asc"), PathOf("high.asc"), PathOf("low.asc")});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  for (const char* words :
       {"low.asc", "high.asc", "mean", "spread", "nature from", "nature to", "within", "3/3"}) {
    EXPECT_NE(run.out.find(words), std::string::npos) << words << " | " << run.out;
  }
  const Json all = Measured({PathOf("low.asc"), PathOf("high.asc")});
  const double low = all["lands"][0]["measures"]["mean_slope_deg"]["value"];
  const double high = all["lands"][1]["measures"]["mean_slope_deg"]["value"];
  EXPECT_GT(high, 1.5 * low);
  EXPECT_NEAR(all["summary"]["mean_slope_deg"]["mean"], 0.5 * (low + high), 1e-9);
  EXPECT_NEAR(all["summary"]["mean_slope_deg"]["spread"], (high - low) / std::sqrt(2.0), 1e-9);
  EXPECT_EQ(all["summary"]["mean_slope_deg"]["within"], 2);
}

TEST_F(MeasureCommandTest, HoldsTheMedianSlopeAgainstLandOfTheKindThatItIsSaidToBe) {
  Write("steep.asc", HillsAsc(30.0));
  Write("level.asc", HillsAsc(0.5));
  const auto within = [this](const std::string& file, const std::string& kind) {
    const ProgramRun run = RunProgram({"measure", PathOf(file), "--json", "--kind", kind});
    EXPECT_EQ(run.exit_status, 0) << run.err;
    const Json land = Json::parse(run.out)["lands"][0];
    return land["measures"]["median_slope_deg"]["within"].get<bool>();
  };
  EXPECT_TRUE(within("level.asc", "plain"));
  EXPECT_FALSE(within("level.asc", "hills"));
  EXPECT_FALSE(within("level.asc", "mountains"));
  EXPECT_FALSE(within("steep.asc", "plain"));
  EXPECT_FALSE(within("steep.asc", "hills"));
  EXPECT_TRUE(within("steep.asc", "mountains"));
  EXPECT_TRUE(within("steep.asc", "any") && within("level.asc", "any"));
  ExpectFailure(2, {"measure", PathOf("level.asc"), "--kind", "ocean"},
                {"--kind", "any, plain, hills, mountains"});
}

TEST_F(MeasureCommandTest, MeasuresTheSameEveryTime) {
  Write("hills.asc", HillsAsc(16.0));
  const std::vector<std::string> arguments = {"measure", PathOf("hills.asc"), "--json"};
  EXPECT_EQ(RunProgram(arguments).out, RunProgram(arguments).out);
}

TEST_F(MeasureCommandTest, RefusesWhatItCannotMeasure) {
  Write("slope.pgm", SlopePgm(80, 80));
  Write("small.pgm", SlopePgm(63, 80));
  Write("letter.asc", "Dear aunt,");
  ExpectFailure(2, {"measure"}, {"PATH"});
  ExpectFailure(2, {"measure", PathOf("slope.pgm")}, {"slope.pgm", "--size"});
  ExpectFailure(2, {"measure", PathOf("small.pgm"), "--size", "100"},
                {"small.pgm", "63 x 80", "64 x 64"});
  ExpectFailure(2, {"measure", PathOf("letter.asc")}, {"letter.asc"});
  Write("hills.asc", HillsAsc(40.0));
  ExpectFailure(2, {"measure", PathOf("hills.asc"), "--elevation-unit", "degrees"},
                {"hills.asc", "said to be in degrees"});
  ExpectFailure(2, {"measure", PathOf("hills.asc"), "--elevation-unit", "feet"},
                {"--elevation-unit", "degrees, metres"});
  ExpectFailure(2, {"measure", PathOf("slope.pgm"), "--size", "0", "--height-scale", "99999"},
                {"--size", "--height-scale"});
  ExpectFailure(2, {"measure", PathOf("slope.pgm"), "--height-scale", "5"}, {"--size"});
  ExpectFailure(2, {"measure", PathOf("slope.pgm"), "--size", "wide"}, {"--size", "wide"});
  ExpectFailure(1, {"measure", PathOf("nowhere.asc")}, {"nowhere.asc"});
  ExpectFailure(1, {"measure", PathOf("")}, {"world.json"});
}

}  // namespace
}  // namespace latticeworld
