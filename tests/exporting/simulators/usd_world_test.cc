#include "latticeworld/exporting/simulators/usd_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "generation/test_world.h"
#include "latticeworld/exporting/chosen_assets.h"
#include "latticeworld/exporting/simulators/usd_text.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/surface_table.h"

namespace latticeworld {
namespace {

// The lines of a prim's own block, by its path, as UsdText indents them.
std::map<std::string, std::map<std::string, std::string>> PrimsOf(const std::string& usda) {
  std::map<std::string, std::map<std::string, std::string>> prims;
  std::vector<std::string> path;
  std::istringstream lines(usda.substr(usda.find("\n)\n") + 3));
  for (std::string line; std::getline(lines, line);) {
    line.erase(0, line.find_first_not_of(' '));
    const std::size_t quote = line.find('"'), equals = line.find(" = ");
    if (line.rfind("def ", 0) == 0 || line.rfind("class ", 0) == 0) {
      path.push_back((path.empty() ? "" : path.back()) + "/" +
                     line.substr(quote + 1, line.find('"', quote + 1) - quote - 1));
      EXPECT_TRUE(prims.emplace(path.back(), std::map<std::string, std::string>()).second) << line;
      prims[path.back()]["type"] = line.substr(line.find(' ') + 1, quote - line.find(' ') - 2);
    } else if (line == "}") {
      EXPECT_FALSE(path.empty());
      if (!path.empty()) path.pop_back();
    } else if (equals != std::string::npos && !path.empty()) {
      prims[path.back()][line.substr(0, equals)] = line.substr(equals + 3);
    }
  }
  EXPECT_TRUE(path.empty());
  return prims;
}

// Every number of a text, whatever stands between.
std::vector<double> NumbersOf(std::string text) {
  for (char& c : text) {
    if (c == '(' || c == ')' || c == '[' || c == ']' || c == ',') c = ' ';
  }
  std::istringstream stream(text);
  std::vector<double> numbers;
  for (double number; stream >> number;) numbers.push_back(number);
  return numbers;
}

class UsdWorldTest : public ::testing::Test {
 protected:
  const std::shared_ptr<World> world_ = MakeTestWorld();
  const Scene& scene_ = *world_->scene;

  std::string Make(const UsdOptions& options = {},
                   const std::optional<GeoOrigin>& origin = std::nullopt) const {
    const auto files = UsdFiles(scene_, "lake \"and\" wood", origin, options, Progress());
    EXPECT_TRUE(files.ok()) << files.status().ToString();
    EXPECT_EQ(files->size(), 2u);
    EXPECT_EQ((*files)[0].name, "world.usda");
    EXPECT_EQ((*files)[1].name, "ground.jpg");
    return (*files)[0].content;
  }
};

TEST_F(UsdWorldTest, TheGroundHasEveryCellOfTheRegionInItsPlace) {
  for (const auto& region : {std::optional<ExportRegion>(),
                             std::optional<ExportRegion>(ExportRegion{-4.0, -2.0, 6.1, 3.0})}) {
    UsdOptions options;
    options.region = region;
    auto prims = PrimsOf(Make(options));
    const auto points = NumbersOf(prims["/World/ground"]["point3f[] points"]);
    const int cells = scene_.geometry().rows();
    ASSERT_EQ(points.size(), 3u * (region ? 20 * 10 : cells * cells));
    for (std::size_t i = 0; i < points.size(); i += 3) {
      const CellIndex cell = scene_.geometry().CellAt({points[i], points[i + 1]});
      const WorldPoint center = scene_.geometry().CenterOf(cell);
      EXPECT_NEAR(points[i], center.x_m, 1e-5);
      EXPECT_NEAR(points[i + 1], center.y_m, 1e-5);
      EXPECT_NEAR(points[i + 2], scene_.terrain->ground.height_m()[cell], 1e-5);
    }
  }
}

TEST_F(UsdWorldTest, WithARegionItsMiddleIsTheOriginOfTheStage) {
  UsdOptions options;
  options.region = ExportRegion{-4.0, -2.0, 6.0, 3.0};
  const std::string usda = Make(options, GeoOrigin{47.0, 8.0, 400.0});
  EXPECT_NE(usda.find("double3 map_origin = (1, 0.5, 0)\n"), std::string::npos);
  EXPECT_NE(usda.find("double3 geo = (47, 8, 400)\n"), std::string::npos);
  EXPECT_NE(usda.find(R"(string world = "lake \"and\" wood")"), std::string::npos);
  EXPECT_EQ(PrimsOf(usda)["/World"]["double3 xformOp:translate"], "(-1, -0.5, -0)");
  EXPECT_EQ(PrimsOf(Make())["/World"].count("double3 xformOp:translate"), 0u);
}

TEST_F(UsdWorldTest, EveryTriangleOfTheGroundIsOfOneClassWithItsFriction) {
  auto prims = PrimsOf(Make());
  const SurfaceTable surfaces(scene_, scene_.atmosphere.ground());
  std::vector<double> all;
  double sum = 0.0;
  for (const auto& entry : EnumNames(SurfaceClass{})) {
    std::string name(entry.name);
    std::replace(name.begin(), name.end(), ' ', '_');
    const auto subset = prims.find("/World/ground/" + name);
    if (subset == prims.end()) continue;
    const auto triangles = NumbersOf(subset->second["int[] indices"]);
    all.insert(all.end(), triangles.begin(), triangles.end());
    const double friction = surfaces.Of(entry.value).friction;
    sum += friction * static_cast<double>(triangles.size());
    EXPECT_EQ(subset->second["token[] semantics:labels:class"],
              "[\"" + std::string(entry.name) + "\"]");
    EXPECT_EQ(subset->second["rel material:binding:physics"],
              "</World/looks/friction_" + name + ">");
    EXPECT_DOUBLE_EQ(
        std::stod(prims["/World/looks/friction_" + name]["float physics:staticFriction"]),
        friction);
  }
  std::sort(all.begin(), all.end());
  std::vector<double> each(NumbersOf(prims["/World/ground"]["int[] faceVertexCounts"]).size());
  std::iota(each.begin(), each.end(), 0.0);
  EXPECT_EQ(all, each);
  EXPECT_NEAR(std::stod(prims["/World/looks/friction_ground"]["float physics:staticFriction"]),
              sum / static_cast<double>(each.size()), 1e-9);
}

TEST_F(UsdWorldTest, InstancersHaveEveryThingOnceByItsNumber) {
  auto prims = PrimsOf(Make());
  std::set<double> seen;
  for (auto& [path, prim] : prims) {
    if (prim["type"] != "PointInstancer") continue;
    const auto ids = NumbersOf(prim["int64[] ids"]);
    const auto places = NumbersOf(prim["point3f[] positions"]);
    const auto sizes = NumbersOf(prim["float3[] scales"]);
    const auto turns = NumbersOf(prim["quatf[] orientationsf"]);
    const auto models = NumbersOf(prim["int[] protoIndices"]);
    ASSERT_EQ(places.size(), 3 * ids.size());
    ASSERT_EQ(sizes.size(), 3 * ids.size());
    ASSERT_EQ(turns.size(), 4 * ids.size());
    ASSERT_EQ(models.size(), ids.size());
    const std::string& prototypes = prim["rel prototypes"];
    const auto count = std::count(prototypes.begin(), prototypes.end(), '<');
    EXPECT_LT(*std::max_element(models.begin(), models.end()), static_cast<double>(count));
    for (std::size_t i = 0; i < ids.size(); ++i) {
      EXPECT_TRUE(seen.insert(ids[i]).second) << ids[i];
      const Asset& asset = scene_.assets[static_cast<std::size_t>(ids[i])];
      EXPECT_FLOAT_EQ(places[3 * i], asset.x_m);
      EXPECT_FLOAT_EQ(places[3 * i + 1], asset.y_m);
      EXPECT_FLOAT_EQ(places[3 * i + 2], asset.z_m);
      EXPECT_FLOAT_EQ(sizes[3 * i + 2], asset.height_m);
      const double yaw_rad = 2.0 * std::atan2(turns[4 * i + 3], turns[4 * i]);
      EXPECT_NEAR(std::remainder(yaw_rad - asset.yaw_rad, 2.0 * M_PI), 0.0, 1e-6);
      std::string kind(NameOf(asset.kind));
      EXPECT_EQ(path, "/World/assets/" + kind);
    }
  }
  EXPECT_EQ(seen.size(), scene_.assets.size());
}

TEST_F(UsdWorldTest, SolidThingsCollideAtTheirOwnSize) {
  auto prims = PrimsOf(Make());
  std::size_t solids = 0;
  for (std::size_t i = 0; i < scene_.assets.size(); ++i) {
    const Asset& asset = scene_.assets[i];
    const Collision form = scene_.catalogue->models()[asset.model].collision;
    const auto solid = prims.find("/World/solids/asset_" + std::to_string(i) + "_solid");
    EXPECT_EQ(solid != prims.end(), form != Collision::kNone);
    if (solid == prims.end()) continue;
    ++solids;
    const auto place = NumbersOf(solid->second["double3 xformOp:translate"]);
    EXPECT_FLOAT_EQ(place[0], asset.x_m);
    EXPECT_NEAR(place[2], asset.z_m + 0.5f * asset.height_m, 1e-5);
    if (form == Collision::kTrunk) {
      EXPECT_FLOAT_EQ(std::stof(solid->second["double radius"]), asset.trunk_radius_m);
      EXPECT_FLOAT_EQ(std::stof(solid->second["double height"]), asset.height_m);
    } else if (form == Collision::kBox) {
      EXPECT_FLOAT_EQ(NumbersOf(solid->second["double3 xformOp:scale"])[0], asset.half_length_m);
    }
  }
  EXPECT_GT(solids, 0u);
  EXPECT_EQ(prims["/World/ground"]["uniform token physics:approximation"], "\"none\"");
}

TEST_F(UsdWorldTest, ExpandedThereIsAPrimAThingAndNoInstancer) {
  UsdOptions options;
  options.expand = true;
  options.small_plants = false;
  auto prims = PrimsOf(Make(options));
  std::size_t things = 0;
  for (std::size_t i = 0; i < scene_.assets.size(); ++i) {
    const auto thing = prims.find("/World/assets/asset_" + std::to_string(i));
    EXPECT_EQ(thing != prims.end(), !IsSmallPlant(scene_.assets[i].kind));
    if (thing == prims.end()) continue;
    ++things;
    EXPECT_EQ(thing->second["instanceable"], "true");
    std::string look = thing->second["prepend references"];
    look = look.substr(1, look.size() - 2);
    EXPECT_EQ(prims.count(look + "/mesh"), 1u) << look;
  }
  EXPECT_GT(things, 0u);
  for (auto& [path, prim] : prims) EXPECT_NE(prim["type"], "PointInstancer") << path;
}

TEST_F(UsdWorldTest, EveryAgentHasItsStart) {
  auto prims = PrimsOf(Make());
  ASSERT_FALSE(scene_.agents.empty());
  for (const AgentStart& agent : scene_.agents) {
    const auto start = prims.find("/World/starts/start_" + agent.name);
    ASSERT_NE(start, prims.end()) << agent.name;
    const auto place = NumbersOf(start->second["double3 xformOp:translate"]);
    EXPECT_DOUBLE_EQ(place[0], agent.position.x_m);
    EXPECT_NEAR(std::remainder(std::stod(start->second["double xformOp:rotateZ"]) * M_PI / 180.0 -
                                   agent.heading_rad,
                               2.0 * M_PI),
                0.0, 1e-9);
  }
}

TEST_F(UsdWorldTest, TheSameWorldAndOptionsGiveTheSameText) { EXPECT_EQ(Make(), Make()); }

TEST_F(UsdWorldTest, UnusableOptionsAreNamed) {
  UsdOptions options;
  options.ground_step_m = 0.01;
  options.texture_px = 3;
  options.detail = 9;
  const auto files = UsdFiles(scene_, "w", std::nullopt, options, Progress());
  ASSERT_FALSE(files.ok());
  for (const char* word : {"ground_step_m", "texture_px", "detail"})
    EXPECT_NE(files.status().ToString().find(word), std::string::npos) << word;
}

TEST(UsdTextTest, NumbersReadBackAsTheSame) {
  const std::vector<Eigen::Vector3f> values = {{0.1f, -1e-7f, 12345.678f}};
  const auto read = NumbersOf(UsdArray(values));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(static_cast<float>(read[i]), values[0][i]);
  EXPECT_EQ(UsdQuoted("a \"b\" \\ c\nd"), R"("a \"b\" \\ c d")");
}

}  // namespace
}  // namespace latticeworld
