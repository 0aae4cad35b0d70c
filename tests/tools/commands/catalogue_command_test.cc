#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tools/run_program.h"

namespace latticeworld {
namespace {

class CatalogueCommandTest : public ProgramTest {
 protected:
  static void ExpectWords(const std::string& text, const std::vector<std::string>& all) {
    for (const std::string& words : all) {
      EXPECT_NE(text.find(words), std::string::npos) << words << " | " << text;
    }
  }
};

// A flower with a colour of its own.
constexpr char kCornflower[] = R"({"type": "flower",
  "materials": [{"name": "cornflower", "models": ["cornflower"], "color": ["#4f63b0", "#6478c2"],
    "density_kgpm3": 900, "elastic_modulus_pa": 4e8, "bending_strength_pa": 1.2e7,
    "lidar_reflectance": 0.45, "radar_sigma0_db": -14}],
  "models": [{"name": "cornflower", "kind": "flower", "shape": "flower", "collision": "none",
    "height_m": {"mean": 0.5, "deviation": 0.1, "low": 0.3, "high": 0.8},
    "spread": {"mean": 0.4, "deviation": 0.05, "low": 0.3, "high": 0.5}, "share": 1}]})";

TEST_F(CatalogueCommandTest, CountsTheMethodsTable) {
  const ProgramRun run = RunProgram({"catalogue"});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  ExpectWords(run.out, {"asset type     seasonal  material  models  continuous",
                        "grass                 3         4       8  density\n",
                        "forest               18         4       6  density, rotation\n",
                        "architecture          4         3      21  density, rotation, scale\n",
                        "total                49        37      49\n",
                        "  material: poppy, daisy, lavender, heather\n",
                        "  models: oak, birch, maple, pine, spruce, fruit tree\n"});
}

TEST_F(CatalogueCommandTest, SaysWhatFilesAdd) {
  Write("cornflower.json", kCornflower);
  const ProgramRun run = RunProgram({"catalogue", PathOf("cornflower.json")});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  ExpectWords(run.out, {"total                49        38      50\n",
                        "added to flower\n  material: cornflower\n  models: cornflower\n"});
}

TEST_F(CatalogueCommandTest, SaysWhatFilesReplace) {
  std::string poppy = kCornflower;
  for (const std::string name = "cornflower"; poppy.find(name) != std::string::npos;) {
    poppy.replace(poppy.find(name), name.size(), "poppy");
  }
  Write("poppy.json", poppy);
  const ProgramRun run = RunProgram({"catalogue", PathOf("poppy.json")});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  ExpectWords(run.out, {"total                49        37      49\n",
                        "replaced in flower by poppy.json\n  material: poppy\n  models: poppy\n"});
}

TEST_F(CatalogueCommandTest, SaysWhichDensitiesFilesSet) {
  Write("sparse.json", R"({"type": "forest", "density": [
    {"kind": "tree", "suburb": {"G": 0.5}, "wild": {"F": 3}}]})");
  const ProgramRun run = RunProgram({"catalogue", PathOf("sparse.json")});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  ExpectWords(run.out, {"densities in forest: tree suburb/G 0.5, tree wild/F 3\n"});
}

TEST_F(CatalogueCommandTest, ReportsEveryFaultWithFileAndPointer) {
  Write("a.json", R"({"type": "road", "lanes": 2})");
  Write("b.json", R"({"type": "stone", "models": [7]})");
  const ProgramRun run = RunProgram({"catalogue", PathOf("a.json"), PathOf("b.json")});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_EQ(run.out, "");
  ExpectWords(run.err, {"a.json#/lanes: ", "b.json#/models/0: "});
}

TEST_F(CatalogueCommandTest, SaysWhatIsNotThere) {
  const ProgramRun run = RunProgram({"catalogue", PathOf("none.json")});
  EXPECT_EQ(run.exit_status, 1);
  ExpectWords(run.err, {"none.json"});
}

TEST_F(CatalogueCommandTest, PrintsTheSchema) {
  const ProgramRun run = RunProgram({"catalogue", "--schema"});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  const auto schema = nlohmann::json::parse(run.out);
  EXPECT_EQ(schema.at("title"), "LatticeWorld catalogue file");
}

}  // namespace
}  // namespace latticeworld
