#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/run_program.h"

namespace latticeworld {
namespace {

class ExportCommandTest : public ProgramTest {
 protected:
  ExportCommandTest() {
    const ProgramRun run =
        RunProgram({"generate", "--layout", "A wood in the north, a lake in the south.", "--seed",
                    "3", "--size", "32", "--resolution", "1", "--out", PathOf("world")});
    EXPECT_EQ(run.exit_status, 0) << run.err;
  }

  ProgramRun Export(const std::string& format, const std::string& out,
                    const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments = {"export", PathOf("world"), "--to",
                                          format,   "--out",         PathOf(out)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return RunProgram(arguments);
  }
};

TEST_F(ExportCommandTest, EveryFormatIsWrittenAndTheSameTwice) {
  for (const std::string format : {"glb", "octomap", "ply", "las"}) {
    const ProgramRun run = Export(format, "a");
    ASSERT_EQ(run.exit_status, 0) << run.err;
    EXPECT_NE(run.out.find(" as " + format + ", "), std::string::npos) << run.out;
    const std::string once = Read("a");
    ASSERT_EQ(Export(format, "a").exit_status, 0);
    EXPECT_EQ(Read("a"), once) << format;
  }
  for (const std::string format : {"usd", "sdf", "mjcf", "geotiff", "heights", "map"}) {
    ASSERT_EQ(Export(format, format).exit_status, 0);
    EXPECT_TRUE(std::filesystem::is_directory(PathOf(format)));
  }
  EXPECT_EQ(Read("map/map.pgm"), Read("world/map.pgm"));
  EXPECT_EQ(Read("map/map.yaml"), Read("world/map.yaml"));
}

TEST_F(ExportCommandTest, AMapOfThreeValuesIsWrittenWhereItIsAskedFor) {
  ASSERT_EQ(Export("map", "three", {"--map-values", "trinary"}).exit_status, 0);
  EXPECT_NE(Read("three/map.yaml").find("mode: trinary"), std::string::npos);
  const std::string pgm = Read("three/map.pgm");
  for (const char grey : pgm.substr(pgm.size() - 32 * 32)) {
    EXPECT_TRUE(grey == '\0' || grey == static_cast<char>(254)) << static_cast<int>(grey);
  }
  const ProgramRun refused = Export("map", "four", {"--map-values", "binary"});
  EXPECT_EQ(refused.exit_status, 2);
  EXPECT_NE(refused.err.find("graded, trinary"), std::string::npos) << refused.err;
  EXPECT_EQ(Export("ply", "five", {"--map-values", "trinary"}).exit_status, 2);
}

TEST_F(ExportCommandTest, WhatCannotBeExportedIsNamedAndNothingIsWritten) {
  struct Case {
    std::string format, out;
    std::vector<std::string> options;
    int exit_status;
    std::vector<std::string> words;
  };
  const std::vector<Case> cases = {
      {"stl", "a", {}, 2, {"--to", "stl", "glb", "las"}},
      {"glb", "a", {"--region", "0,0,10"}, 2, {"--region", "0,0,10", "four numbers"}},
      {"glb", "a", {"--region=-50,0,10,10"}, 2, {"-50,0,10,10", "-16 to 16"}},
      {"ply", "a", {"--region", "0,0,nan,10"}, 2, {"0,0,nan,10"}},
      {"map", "a", {"--spacing", "1"}, 2, {"--spacing", "ply, las"}},
      {"glb", "a", {"--detail", "7"}, 2, {"--detail", "7", "0 to 2"}},
      {"sdf", "a", {"--heightmap-size", "100"}, 2, {"100", "2^n + 1"}},
      {"mjcf", "a", {"--heightmap-size", "129"}, 2, {"--heightmap-size", "sdf"}},
      {"mjcf", "a", {"--region=-50,0,10,10"}, 2, {"-50,0,10,10", "-16 to 16"}},
      {"usd", "a", {"--region=-50,0,10,10"}, 2, {"-50,0,10,10", "-16 to 16"}},
      {"usd", "a", {"--ground-step", "0"}, 2, {"--ground-step", "0.05"}},
      {"usd", "a", {"--no-agents"}, 2, {"--no-agents", "glb"}},
      {"heights", "a", {"--region=-50,0,10,10"}, 2, {"-50,0,10,10", "-16 to 16"}},
      {"heights", "a", {"--detail", "1"}, 2, {"--detail", "mjcf"}},
      {"las", "a", {"--spacing", "1e-9"}, 2, {"--spacing", "0.02"}},
      {"octomap", "a", {"--resolution", "99"}, 2, {"--resolution", "99", "16"}},
      {"sdf",
       "a",
       {"--region=-50,0,10,10", "--texture", "1", "--detail", "7", "--heightmap-bits", "12"},
       2,
       {"--region", "--texture", "--detail", "--heightmap-bits"}},
      {"map",
       "a",
       {"--region", "0,0,10", "--spacing", "few", "--seed", "-1"},
       2,
       {"--region", "four numbers", "--spacing", "--seed"}},
      {"glb", "no/such/folder/a", {}, 1, {"--out", "No such file"}},
      {"sdf", "no/such/folder/a", {}, 1, {"--out", "a"}},
      {"map", "world", {}, 1, {"--out", "already exists"}}};
  for (const Case& asked : cases) {
    const ProgramRun run = Export(asked.format, asked.out, asked.options);
    EXPECT_EQ(run.exit_status, asked.exit_status) << asked.format << " | " << run.err;
    for (const std::string& word : asked.words)
      EXPECT_NE(run.err.find(word), std::string::npos) << word << " | " << run.err;
    EXPECT_EQ(Entries(), std::vector<std::string>{"world"});
  }
}

TEST_F(ExportCommandTest, AFileWithInstancesWarnsOfReadersThatLeaveThemOut) {
  const ProgramRun instances = Export("glb", "a");
  ASSERT_EQ(instances.exit_status, 0) << instances.err;
  for (const char* word : {"warning: ", "trimesh", "Open3D", "newton", "Blender", "--expand"})
    EXPECT_NE(instances.err.find(word), std::string::npos) << word << " | " << instances.err;
  const ProgramRun usd = Export("usd", "d");
  for (const char* word : {"warning: ", "PointInstancer", "newton", "--expand"})
    EXPECT_NE(usd.err.find(word), std::string::npos) << word << " | " << usd.err;
  for (const ProgramRun& run :
       {Export("glb", "b", {"--expand"}), Export("las", "c"), Export("usd", "e", {"--expand"})}) {
    ASSERT_EQ(run.exit_status, 0) << run.err;
    EXPECT_EQ(run.err.find("warning"), std::string::npos) << run.err;
  }
}

TEST_F(ExportCommandTest, ARegionAndDetailReachTheFolders) {
  ASSERT_EQ(Export("heights", "h", {"--region=-4,-3,4,3"}).exit_status, 0);
  EXPECT_NE(Read("h/heights.npy").find("'shape': (6, 8)"), std::string::npos);
  ASSERT_EQ(Export("mjcf", "m", {"--region=-4,-3,4,3", "--plants", "all"}).exit_status, 0);
  EXPECT_NE(Read("m/world.xml").find("nrow=\"8\" ncol=\"6\""), std::string::npos);
  ASSERT_EQ(Export("mjcf", "fine", {"--detail", "0"}).exit_status, 0);
  ASSERT_EQ(Export("mjcf", "coarse", {"--detail", "2"}).exit_status, 0);
  const auto bytes = [this](const std::string& folder) {
    std::uintmax_t sum = 0;
    for (const auto& entry : std::filesystem::directory_iterator(PathOf(folder + "/meshes")))
      sum += entry.file_size();
    return sum;
  };
  EXPECT_GT(bytes("fine"), bytes("coarse"));
}

TEST_F(ExportCommandTest, WithoutABundleThereIsNothingToExport) {
  const ProgramRun run =
      RunProgram({"export", PathOf("nothing"), "--to", "glb", "--out", PathOf("a")});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_NE(run.err.find("nothing"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace latticeworld
