#include "latticeworld/exporting/gltf/world_glb.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "exporting/glb_reader.h"
#include "generation/test_world.h"
#include "latticeworld/exporting/ground_mesh.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {
namespace {

constexpr char kInstancing[] = "EXT_mesh_gpu_instancing";

class WorldGlbTest : public ::testing::Test {
 protected:
  const std::shared_ptr<World> world_ = MakeTestWorld();
  const Scene& scene_ = *world_->scene;
  const std::shared_ptr<const SpeciesCatalogue> species_ = SpeciesCatalogue::BuiltIn();

  Result<std::string> Make(const WorldGlbOptions& options) const {
    return WorldGlb(scene_, *species_, options, Progress());
  }
  // Places of all instances, glTF's axes.
  static std::vector<Eigen::Vector3d> Places(const GlbReader& glb) {
    std::vector<Eigen::Vector3d> places;
    for (const nlohmann::json* node : glb.Children("assets")) {
      const auto& attributes = (*node)["extensions"][kInstancing]["attributes"];
      const auto translations = glb.ReadVectors(attributes["TRANSLATION"]);
      EXPECT_EQ(glb.Read(attributes["ROTATION"]).size(), 4 * translations.size());
      EXPECT_EQ(glb.ReadVectors(attributes["SCALE"]).size(), translations.size());
      places.insert(places.end(), translations.begin(), translations.end());
    }
    return places;
  }
  int AssetsIn(const ExportRegion& region) const {
    int count = 0;
    for (const Asset& asset : scene_.assets) count += region.Holds(asset.position()) ? 1 : 0;
    return count;
  }
};

TEST_F(WorldGlbTest, EveryAssetIsOneInstanceWhereItStands) {
  const GlbReader glb(*Make({}));
  std::multiset<std::array<long, 3>> wanted, found;
  const auto millimetres = [](double x, double y, double z) {
    return std::array<long, 3>{std::lround(1e3 * x), std::lround(1e3 * y), std::lround(1e3 * z)};
  };
  for (const Asset& asset : scene_.assets)
    wanted.insert(millimetres(asset.x_m, asset.y_m, asset.z_m));
  for (const Eigen::Vector3d& place : Places(glb))
    found.insert(millimetres(place.x(), -place.z(), place.y()));
  ASSERT_FALSE(wanted.empty());
  EXPECT_EQ(found, wanted);
}

TEST_F(WorldGlbTest, EveryInstanceSaysWhichAssetItIs) {
  const GlbReader glb(*Make({}));
  std::set<std::size_t> numbers;
  for (const nlohmann::json* node : glb.Children("assets")) {
    const auto& attributes = (*node)["extensions"][kInstancing]["attributes"];
    const auto places = glb.ReadVectors(attributes["TRANSLATION"]);
    ASSERT_TRUE(attributes.contains("_ASSET"));
    const auto assets = glb.Read(attributes["_ASSET"]);
    ASSERT_EQ(assets.size(), places.size());
    for (std::size_t i = 0; i < assets.size(); ++i) {
      const Asset& asset = scene_.assets.at(static_cast<std::size_t>(assets[i]));
      EXPECT_NEAR(places[i].x(), asset.x_m, 1e-5);
      EXPECT_NEAR(places[i].z(), -asset.y_m, 1e-5);
      numbers.insert(static_cast<std::size_t>(assets[i]));
    }
  }
  EXPECT_EQ(numbers.size(), scene_.assets.size());
}

TEST_F(WorldGlbTest, NodesSayWhatTheyAreOf) {
  WorldGlbOptions expanded;
  expanded.expand = true;
  for (const WorldGlbOptions& options : {WorldGlbOptions(), expanded}) {
    const GlbReader glb(*Make(options));
    for (const char* name : {"ground", "water", "sun"})
      EXPECT_EQ((*glb.Node(name))["extras"]["kind"], name);
    for (const nlohmann::json* node : glb.Children("assets")) {
      const nlohmann::json& extras = (*node)["extras"];
      EXPECT_TRUE(FromName<AssetKind>(extras["kind"].get<std::string>())) << extras;
      EXPECT_EQ(extras.contains("asset"), options.expand);
    }
    for (const auto& [parent, kind] :
         {std::pair<const char*, const char*>{"elements", "element"}, {"agents", "agent"}}) {
      ASSERT_FALSE(glb.Children(parent).empty());
      for (const nlohmann::json* node : glb.Children(parent)) {
        EXPECT_EQ((*node)["extras"]["kind"], kind);
        EXPECT_FALSE((*node)["extras"]["model"].get<std::string>().empty());
      }
    }
  }
}

// three.js takes these characters out of names, so that others could not be found by theirs.
TEST_F(WorldGlbTest, NoNameHoldsWhatReadersTakeOut) {
  WorldGlbOptions expanded;
  expanded.expand = true;
  for (const WorldGlbOptions& options : {WorldGlbOptions(), expanded}) {
    const GlbReader glb(*Make(options));
    for (const char* list : {"nodes", "meshes", "materials", "images"}) {
      for (const auto& entry : glb.json()[list]) {
        const std::string name = entry["name"];
        EXPECT_EQ(name.find_first_of("[].:/ "), std::string::npos) << list << ": " << name;
      }
    }
  }
}

TEST_F(WorldGlbTest, ExpandedItIsOneNodeAThingAndNeedsNoExtension) {
  WorldGlbOptions options;
  options.expand = true;
  const GlbReader glb(*Make(options));
  EXPECT_EQ(glb.Children("assets").size(), scene_.assets.size());
  EXPECT_FALSE(glb.json().contains("extensionsRequired"));
  std::set<std::string> names;
  for (const nlohmann::json* node : glb.Children("assets")) {
    const std::string name = (*node)["name"];
    names.insert(name);
    const auto number = (*node)["extras"]["asset"].get<std::size_t>();
    const Asset& asset = scene_.assets.at(number);
    EXPECT_EQ(name.substr(name.rfind('_') + 1), std::to_string(number));
    EXPECT_NEAR((*node)["translation"][0].get<double>(), asset.x_m, 1e-5);
    EXPECT_NEAR((*node)["scale"][1].get<double>(), asset.height_m, 1e-5);
    // Turned about the vertical by its yaw.
    EXPECT_NEAR(2.0 * std::atan2((*node)["rotation"][1].get<double>(),
                                 (*node)["rotation"][3].get<double>()),
                std::remainder(asset.yaw_rad, 2.0 * M_PI), 1e-5);
  }
  EXPECT_EQ(names.size(), scene_.assets.size());
}

TEST_F(WorldGlbTest, VerticesOfTheGroundLieOnTheHeightField) {
  const GlbReader glb(*Make({}));
  const int mesh = (*glb.Node("ground"))["mesh"];
  const auto& primitive = glb.json()["meshes"][mesh]["primitives"][0];
  const auto positions = glb.ReadVectors(primitive["attributes"]["POSITION"]);
  ASSERT_GT(positions.size(), 64u * 64u);
  for (const Eigen::Vector3d& p : positions) {
    ASSERT_NEAR(p.y(), scene_.terrain->ground.HeightAt({p.x(), -p.z()}), 1e-4);
  }
  const double half_m = scene_.geometry().half_size_m();
  EXPECT_NEAR(positions.front().x(), -half_m, 1e-6);
  EXPECT_NEAR(positions.front().z(), -half_m, 1e-6);  // north
  // Every corner is of a vertex, and every triangle faces up.
  const auto corners = glb.Read(primitive["indices"]);
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const auto at = [&](std::size_t k) {
      return positions.at(static_cast<std::size_t>(corners[i + k]));
    };
    ASSERT_GT((at(1) - at(0)).cross(at(2) - at(0)).y(), 0.0);
  }
}

TEST_F(WorldGlbTest, WaterLiesAtItsLevelAndCoversTheLake) {
  const GlbReader glb(*Make({}));
  ASSERT_NE(glb.Node("water"), nullptr);
  const auto& primitive = glb.json()["meshes"][(*glb.Node("water"))["mesh"].get<int>()];
  const auto positions = glb.ReadVectors(primitive["primitives"][0]["attributes"]["POSITION"]);
  for (const Eigen::Vector3d& p : positions) ASSERT_NEAR(p.y(), -0.9, 1e-5);
}

TEST_F(WorldGlbTest, ARegionCutsGroundAndThings) {
  WorldGlbOptions options;
  options.region = ExportRegion{-12.0, -3.0, 5.0, 11.0};
  const GlbReader glb(*Make(options));
  EXPECT_EQ(static_cast<int>(Places(glb).size()), AssetsIn(*options.region));
  const auto& ground = glb.json()["meshes"][(*glb.Node("ground"))["mesh"].get<int>()];
  const auto& accessor =
      glb.json()["accessors"][ground["primitives"][0]["attributes"]["POSITION"].get<int>()];
  EXPECT_NEAR(accessor["min"][0].get<double>(), -12.0, 1e-6);
  EXPECT_NEAR(accessor["max"][0].get<double>(), 5.0, 1e-6);
  EXPECT_NEAR(accessor["min"][2].get<double>(), -11.0, 1e-6);
  EXPECT_NEAR(accessor["max"][2].get<double>(), 3.0, 1e-6);
}

TEST_F(WorldGlbTest, AgentsAndPropsStandWhereTheyBegin) {
  const GlbReader glb(*Make({}));
  EXPECT_EQ(glb.Children("agents").size(), scene_.agents.size());
  EXPECT_EQ(glb.Children("elements").size(), scene_.props.size());
  for (const AgentStart& agent : scene_.agents) {
    const nlohmann::json* node = glb.Node(agent.name);
    ASSERT_NE(node, nullptr) << agent.name;
    EXPECT_NEAR((*node)["translation"][2].get<double>(), -agent.position.y_m, 1e-5);
  }
  WorldGlbOptions without;
  without.agents = false;
  EXPECT_EQ(GlbReader(*Make(without)).Node("agents"), nullptr);
}

TEST_F(WorldGlbTest, TheSunShinesFromWhereItStands) {
  const GlbReader glb(*Make({}));
  const auto& turn = (*glb.Node("sun"))["rotation"];
  const Eigen::Quaterniond rotation(turn[3].get<double>(), turn[0].get<double>(),
                                    turn[1].get<double>(), turn[2].get<double>());
  const Eigen::Vector3d towards = rotation * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d& sun = scene_.atmosphere.sun_direction;
  EXPECT_NEAR(towards.x(), sun.x(), 1e-4);
  EXPECT_NEAR(towards.y(), sun.z(), 1e-4);
  EXPECT_NEAR(towards.z(), -sun.y(), 1e-4);
}

// Greatest height between a lattice's surface and the ground at the centres of its cells [m].
double GroundError(const Terrain& terrain, const SurfaceLattice& lattice) {
  const GridGeometry& geometry = terrain.geometry();
  const Grid<float>& height_m = terrain.ground.height_m();
  const SurfaceMesh mesh = GroundMesh(terrain, lattice);
  const auto z = [&](int row, int col) {
    return static_cast<double>(
        mesh.positions_m[static_cast<std::size_t>(row) * lattice.cols + col].z());
  };
  double worst_m = 0.0;
  for (int r = 0; r < geometry.rows(); ++r) {
    for (int c = 0; c < geometry.cols(); ++c) {
      const WorldPoint point = geometry.CenterOf({r, c});
      if (!lattice.region.Holds(point)) continue;
      const double col =
          (point.x_m - lattice.region.west_m) / lattice.region.width_m() * (lattice.cols - 1);
      const double row =
          (lattice.region.north_m - point.y_m) / lattice.region.depth_m() * (lattice.rows - 1);
      const int west = std::clamp(static_cast<int>(col), 0, lattice.cols - 2);
      const int north = std::clamp(static_cast<int>(row), 0, lattice.rows - 2);
      const double u = col - west, v = row - north;
      const double nw = z(north, west), se = z(north + 1, west + 1);
      const double surface =
          u > v ? nw + u * (z(north, west + 1) - nw) + v * (se - z(north, west + 1))
                : nw + v * (z(north + 1, west) - nw) + u * (se - z(north + 1, west));
      worst_m = std::max(worst_m, std::abs(surface - height_m(r, c)));
    }
  }
  return worst_m;
}

TEST_F(WorldGlbTest, CoarserGroundHasFewerVerticesAndAKnownError) {
  const SurfaceLattice fine = MakeLattice(WholeWorld(scene_.geometry()), 0.5, 2049);
  const SurfaceLattice coarse = MakeLattice(WholeWorld(scene_.geometry()), 4.0, 2049);
  EXPECT_EQ(fine.rows, 65);
  EXPECT_EQ(coarse.rows, 9);
  EXPECT_LT(GroundError(*scene_.terrain, fine), GroundError(*scene_.terrain, coarse));
  WorldGlbOptions options;
  options.ground_step_m = 4.0;
  EXPECT_LT(Make(options)->size(), Make({})->size());
}

TEST_F(WorldGlbTest, TheSameWorldGivesTheSameBytes) { EXPECT_EQ(*Make({}), *Make({})); }

TEST_F(WorldGlbTest, UnusableOptionsAreRefused) {
  const double nan = std::nan("");
  for (const ExportRegion& region :
       {ExportRegion{-20.0, -3.0, 5.0, 11.0}, ExportRegion{5.0, -3.0, -5.0, 11.0},
        ExportRegion{0.0, 0.0, 1.0, 1.0}, ExportRegion{nan, 0.0, 10.0, 10.0}}) {
    WorldGlbOptions options;
    options.region = region;
    const auto glb = Make(options);
    ASSERT_FALSE(glb.ok());
    EXPECT_EQ(glb.status().code(), StatusCode::kInvalidArgument);
    EXPECT_NE(glb.status().message().find("-16 to 16"), std::string::npos);
  }
  WorldGlbOptions options;
  options.detail = 3;
  options.texture_px = 0;
  options.ground_step_m = nan;
  options.region = ExportRegion{-20.0, -3.0, 5.0, 11.0};
  const Status status = Make(options).status();
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(status.violations().size(), 4u);
}

TEST_F(WorldGlbTest, WhoCancelsGetsNothing) {
  Progress progress;
  progress.Cancel();
  EXPECT_EQ(WorldGlb(scene_, *species_, {}, progress).status().code(), StatusCode::kCancelled);
}

}  // namespace
}  // namespace latticeworld
