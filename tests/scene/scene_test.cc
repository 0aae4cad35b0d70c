#include "latticeworld/scene/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/densities.h"
#include "latticeworld/scene/placement.h"
#include "latticeworld/scene/road_finder.h"
#include "test_world.h"

namespace latticeworld {
namespace {

constexpr int kSeeds = 20;
constexpr double kDegree = M_PI / 180.0;

std::shared_ptr<const Terrain> Uniform(Vocabulary vocabulary, char letter, double size_m = 256.0) {
  TestGround ground;
  ground.vocabulary = vocabulary;
  ground.size_m = size_m;
  ground.letter_at = [letter](WorldPoint) { return letter; };
  return MakeTerrain(ground);
}

std::vector<Asset> OfKind(const Scene& scene, AssetKind kind) {
  std::vector<Asset> assets;
  std::copy_if(scene.assets.begin(), scene.assets.end(), std::back_inserter(assets),
               [kind](const Asset& asset) { return asset.kind == kind; });
  return assets;
}

bool SameBytes(const Asset& a, const Asset& b) {
  return a.kind == b.kind && a.season_variant == b.season_variant && a.material == b.material &&
         a.x_m == b.x_m && a.y_m == b.y_m && a.z_m == b.z_m && a.yaw_rad == b.yaw_rad &&
         a.scale == b.scale && a.height_m == b.height_m && a.half_length_m == b.half_length_m &&
         a.half_width_m == b.half_width_m && a.trunk_radius_m == b.trunk_radius_m;
}

bool SameBytes(const std::vector<Asset>& a, const std::vector<Asset>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Asset& x, const Asset& y) { return SameBytes(x, y); });
}

double AngleBetween(double a_rad, double b_rad) {
  return std::abs(std::remainder(a_rad - b_rad, 2.0 * M_PI));
}

// The rules that hold for every world.
void ExpectRulesHold(const Scene& scene) {
  const Terrain& terrain = *scene.terrain;
  const double half_m = terrain.geometry().half_size_m();
  for (std::size_t i = 0; i < scene.assets.size(); ++i) {
    const Asset& asset = scene.assets[i];
    const double radius_m = SolidRadius(asset);
    ASSERT_LE(std::abs(asset.x_m) + radius_m, half_m + 1e-4) << NameOf(asset.kind);
    ASSERT_LE(std::abs(asset.y_m) + radius_m, half_m + 1e-4) << NameOf(asset.kind);
    ASSERT_EQ(terrain.WaterDepthAt(asset.position()), 0.0) << NameOf(asset.kind);
    ASSERT_NE(terrain.SurfaceAt(asset.position()), SurfaceClass::kRoad) << NameOf(asset.kind);
    ASSERT_GT(asset.height_m, 0.0f);
    ASSERT_GT(asset.half_length_m, 0.0f);
    for (int i = 0; i < 8 && IsSolid(asset.kind) && asset.kind != AssetKind::kBuilding; ++i) {
      const double reach_m = radius_m + kRoadMargin_m, angle_rad = 2.0 * M_PI * i / 8;
      const WorldPoint rim = {asset.x_m + reach_m * std::cos(angle_rad),
                              asset.y_m + reach_m * std::sin(angle_rad)};
      ASSERT_NE(terrain.SurfaceAt(rim), SurfaceClass::kRoad) << NameOf(asset.kind);
      ASSERT_EQ(terrain.WaterDepthAt(rim), 0.0) << NameOf(asset.kind);
    }
    if (asset.kind == AssetKind::kBuilding) {
      ASSERT_LE(asset.z_m, terrain.ground.HeightAt(asset.position()) + 0.01);
    } else {
      ASSERT_NEAR(asset.z_m, terrain.ground.HeightAt(asset.position()), 1e-3);
    }
    // Nobody else's solid circle, buildings' wider gap included, and no ground cover in a solid.
    const bool building = asset.kind == AssetKind::kBuilding;
    scene.index.ForEachNear(
        asset.position(), radius_m + (building ? kBuildingGap_m : 0.0), [&](std::uint32_t j) {
          if (j == i) return;
          const Asset& other = scene.assets[j];
          const double gap_m = std::hypot(other.x_m - asset.x_m, other.y_m - asset.y_m) - radius_m -
                               SolidRadius(other);
          if (IsSolid(asset.kind)) {
            ASSERT_GE(gap_m, -1e-3);
          } else {
            ASSERT_FALSE(SolidContains(other, asset.position(), 0.0));
          }
          if (building && other.kind == AssetKind::kBuilding) {
            ASSERT_GE(gap_m, kBuildingGap_m - 1e-3);
          }
        });
  }
}

// No part of a solid footprint in water or on a road, cell by cell.
void ExpectFootprintsAreClear(const Scene& scene) {
  const Terrain& terrain = *scene.terrain;
  const GridGeometry& geometry = terrain.geometry();
  for (int row = 0; row < geometry.rows(); ++row) {
    for (int col = 0; col < geometry.cols(); ++col) {
      const WorldPoint centre = geometry.CenterOf({row, col});
      if (terrain.surface(row, col) != SurfaceClass::kRoad &&
          !(terrain.WaterDepthAt(centre) > 0.0)) {
        continue;
      }
      scene.index.ForEachNear(centre, 0.0, [&](std::uint32_t i) {
        ASSERT_FALSE(SolidContains(scene.assets[i], centre, 0.0))
            << NameOf(scene.assets[i].kind) << " over water or road";
      });
    }
  }
}

TEST(SceneTest, NothingOverlapsOrStandsInWaterOrOnRoadsOrOutside) {
  for (int seed = 0; seed < kSeeds; ++seed) {
    for (const auto& vocabulary : EnumNames(Vocabulary{})) {
      SCOPED_TRACE(std::string(vocabulary.name) + " seed " + std::to_string(seed));
      const auto terrain = MakePatchwork(vocabulary.value, seed);
      const SceneAnswer answer = Build(terrain, MakeEnvironment(1.0), seed);
      ASSERT_GT(CountOf(*answer.scene, AssetKind::kTree), 50);
      ExpectRulesHold(*answer.scene);
      ExpectFootprintsAreClear(*answer.scene);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(SceneTest, TheRulesHoldOnGeneratedTerrain) {
  for (int seed = 0; seed < kSeeds; ++seed) {
    for (const auto& vocabulary : EnumNames(Vocabulary{})) {
      SCOPED_TRACE(std::string(vocabulary.name) + " seed " + std::to_string(seed));
      // Patches of 4 x 4 letters, and a road or a rocky band across.
      const std::vector<LayoutClass>& classes = ClassesOf(vocabulary.value);
      SymbolicLayout layout;
      layout.vocabulary = vocabulary.value;
      layout.cells = Grid<char>(kLayoutSize, kLayoutSize, 'R');
      for (int row = 0; row < kLayoutSize; ++row) {
        for (int col = 0; col < kLayoutSize; ++col) {
          if (row == 15) continue;
          const double draw = HashToUnit(seed, row / 4, col / 4);
          layout.cells(row, col) = classes[static_cast<std::size_t>(draw * classes.size())].letter;
        }
      }
      TerrainRequest request;
      request.geometry = GridGeometry::FromCells(192, 288.0);
      request.layout = &layout;
      request.seed = seed;
      Result<Terrain> terrain = BuildTerrain(request, Progress());
      ASSERT_TRUE(terrain.ok()) << terrain.status().ToString();
      const SceneAnswer answer = Build(std::make_shared<const Terrain>(std::move(terrain).value()),
                                       MakeEnvironment(1.0), seed);
      ASSERT_GT(CountOf(*answer.scene, AssetKind::kTree), 50);
      if (vocabulary.value == Vocabulary::kSuburb) {
        EXPECT_GT(CountOf(*answer.scene, AssetKind::kBuilding), 0);
      }
      ExpectRulesHold(*answer.scene);
      ExpectFootprintsAreClear(*answer.scene);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(SceneTest, SameSeedSameBytesOtherSeedOtherWorld) {
  for (const auto& vocabulary : EnumNames(Vocabulary{})) {
    const auto terrain = MakePatchwork(vocabulary.value, 4);
    EnvironmentConfig environment = MakeEnvironment(0.7);
    environment.agents = {{AgentCategory::kSheep, 9, AgentState::kGrazing, Region::kAnywhere}};
    const SceneAnswer first = Build(terrain, environment, 11);
    const SceneAnswer second = Build(terrain, environment, 11);
    EXPECT_TRUE(SameBytes(first.scene->assets, second.scene->assets));
    ASSERT_EQ(first.scene->agents.size(), second.scene->agents.size());
    for (std::size_t i = 0; i < first.scene->agents.size(); ++i) {
      EXPECT_EQ(first.scene->agents[i].name, second.scene->agents[i].name);
      EXPECT_EQ(first.scene->agents[i].position.x_m, second.scene->agents[i].position.x_m);
      EXPECT_EQ(first.scene->agents[i].heading_rad, second.scene->agents[i].heading_rad);
    }
    EXPECT_FALSE(SameBytes(first.scene->assets, Build(terrain, environment, 12).scene->assets));
  }
}

TEST(SceneTest, ChangingOneStageLeavesTheOthersAlone) {
  const auto terrain = MakePatchwork(Vocabulary::kSuburb, 2);
  EnvironmentConfig environment = MakeEnvironment(0.5);
  const SceneAnswer before = Build(terrain, environment, 3);
  environment.fine_of(AssetType::kGrass).density = 0.9;
  environment.fine_of(AssetType::kFlower).density = 0.0;
  const SceneAnswer after = Build(terrain, environment, 3);
  for (const AssetKind kind : {AssetKind::kTree, AssetKind::kStone, AssetKind::kBuilding,
                               AssetKind::kDeadBranch, AssetKind::kCrop}) {
    EXPECT_TRUE(SameBytes(OfKind(*before.scene, kind), OfKind(*after.scene, kind))) << NameOf(kind);
  }
  EXPECT_GT(CountOf(*after.scene, AssetKind::kGrassTuft),
            CountOf(*before.scene, AssetKind::kGrassTuft));
  EXPECT_EQ(CountOf(*after.scene, AssetKind::kFlower), 0);
}

TEST(SceneTest, DensityMeansTheStatedNumberPerHectare) {
  struct Case {
    Vocabulary vocabulary;
    char letter;
    AssetKind kind;
  };
  const std::vector<Case> cases = {{Vocabulary::kSuburb, 'F', AssetKind::kTree},
                                   {Vocabulary::kSuburb, 'F', AssetKind::kDeadBranch},
                                   {Vocabulary::kSuburb, 'G', AssetKind::kGrassTuft},
                                   {Vocabulary::kSuburb, 'G', AssetKind::kFlower},
                                   {Vocabulary::kSuburb, 'A', AssetKind::kCrop},
                                   {Vocabulary::kWild, 'B', AssetKind::kBush},
                                   {Vocabulary::kWild, 'R', AssetKind::kStone}};
  for (const Case& item : cases) {
    const auto terrain = Uniform(item.vocabulary, item.letter);
    for (const double density : {0.0, 0.3, 1.0}) {
      const SceneAnswer answer = Build(terrain, MakeEnvironment(density), 5);
      const double expected =
          PerHectare(item.vocabulary, item.letter, item.kind) * density * 6.5536;  // hectares
      EXPECT_NEAR(CountOf(*answer.scene, item.kind), expected,
                  0.1 * expected + 2.0 * std::sqrt(expected))
          << NameOf(item.kind) << " at " << density;
    }
  }
  EXPECT_EQ(PerHectare(Vocabulary::kWild, 'F', AssetKind::kTree), 400.0);
}

TEST(SceneTest, NoHectareHoldsMoreThanStated) {
  for (const auto& vocabulary : EnumNames(Vocabulary{})) {
    for (const LayoutClass& item : ClassesOf(vocabulary.value)) {
      double sum = 0.0;
      for (const auto& kind : EnumNames(AssetKind{})) {
        sum += PerHectare(vocabulary.value, item.letter, kind.value);
      }
      EXPECT_LE(sum, kMostPerHectare) << item.letter;
    }
  }
}

TEST(SceneTest, LargeWorldsAreThinnedToTheLimitAndSaySo) {
  const auto terrain = Uniform(Vocabulary::kSuburb, 'G', 2048.0);
  const SceneAnswer answer = Build(terrain, MakeEnvironment(1.0), 1);
  EXPECT_LE(static_cast<int>(answer.scene->assets.size()), kMaxAssets);
  EXPECT_GT(static_cast<int>(answer.scene->assets.size()), kMaxAssets / 2);
  ASSERT_FALSE(answer.warnings.empty());
  EXPECT_NE(answer.warnings[0].find("thinned"), std::string::npos) << answer.warnings[0];
}

TEST(SceneTest, TreesVaryAndTheirTrunksFollowTheirHeight) {
  const SceneAnswer answer = Build(Uniform(Vocabulary::kWild, 'F'), MakeEnvironment(1.0), 2);
  const std::vector<Asset> trees = OfKind(*answer.scene, AssetKind::kTree);
  std::set<float> heights, crowns;
  for (const Asset& tree : trees) {
    heights.insert(tree.height_m);
    crowns.insert(tree.half_length_m);
    EXPECT_EQ(tree.half_length_m, tree.half_width_m);
    EXPECT_TRUE(tree.height_m >= 4.0f && tree.height_m <= 28.0f);
    const double diameter_m = std::pow(tree.height_m / 23.6, 1.5);
    EXPECT_NEAR(2.0 * tree.trunk_radius_m, diameter_m, 0.16 * diameter_m);
    EXPECT_LT(tree.trunk_radius_m, tree.half_length_m);
  }
  EXPECT_GT(heights.size(), trees.size() / 2);
  EXPECT_GT(crowns.size(), trees.size() / 2);
}

TEST(SceneTest, BuildingsStandAlongRoadsAndFaceThem) {
  TestGround ground;
  ground.letter_at = [](WorldPoint point) {
    if (std::abs(point.y_m) < 4.0) return 'R';
    return std::abs(point.y_m) < 50.0 ? 'B' : 'G';
  };
  const auto terrain = MakeTerrain(ground);
  for (int seed = 0; seed < kSeeds; ++seed) {
    const SceneAnswer answer = Build(terrain, MakeEnvironment(0.25), seed);
    const std::vector<Asset> buildings = OfKind(*answer.scene, AssetKind::kBuilding);
    ASSERT_GT(buildings.size(), 8u);
    int beside_road = 0;
    for (const Asset& building : buildings) {
      EXPECT_LT(std::abs(building.y_m), 50.0) << "outside the built-up area";
      const double to_road_rad = building.y_m > 0.0f ? -M_PI / 2.0 : M_PI / 2.0;
      if (std::abs(building.y_m) < 40.0) {
        EXPECT_LT(AngleBetween(building.yaw_rad, to_road_rad), 15.0 * kDegree);
      }
      if (std::abs(building.y_m) - building.half_length_m < 4.0 + 8.0) ++beside_road;
    }
    EXPECT_GE(beside_road, static_cast<int>(buildings.size()) / 2);
  }
}

TEST(SceneTest, BuildingsWithoutRoadsFollowTheirArea) {
  TestGround ground;
  ground.letter_at = [](WorldPoint point) {
    return std::abs(point.x_m - point.y_m) < 45.0 ? 'B' : 'G';
  };
  const SceneAnswer answer = Build(MakeTerrain(ground), MakeEnvironment(1.0), 6);
  const std::vector<Asset> buildings = OfKind(*answer.scene, AssetKind::kBuilding);
  ASSERT_GT(buildings.size(), 8u);
  std::set<float> yaws;
  for (const Asset& building : buildings) {
    // Along or across the diagonal, with at most 10 degrees of variation.
    const double off_rad = std::remainder(building.yaw_rad - M_PI / 4.0, M_PI / 2.0);
    EXPECT_LT(std::abs(off_rad), 14.0 * kDegree);
    yaws.insert(building.yaw_rad);
  }
  EXPECT_EQ(yaws.size(), buildings.size());
}

TEST(SceneTest, NoBuildingOnASteepSlope) {
  TestGround ground;
  ground.letter_at = [](WorldPoint) { return 'B'; };
  // Level in the west, 20 degrees in the east.
  ground.height_at_m = [](WorldPoint point) {
    return std::max(0.0, point.x_m) * std::tan(20.0 * kDegree);
  };
  const SceneAnswer answer = Build(MakeTerrain(ground), MakeEnvironment(1.0), 6);
  const std::vector<Asset> buildings = OfKind(*answer.scene, AssetKind::kBuilding);
  ASSERT_GT(buildings.size(), 10u);
  for (const Asset& building : buildings) EXPECT_LT(building.x_m + building.half_width_m, 5.0);
}

TEST(SceneTest, WildWorldsHaveNoBuildingsOrCrops) {
  const SceneAnswer answer = Build(MakePatchwork(Vocabulary::kWild, 1), MakeEnvironment(1.0), 1);
  EXPECT_EQ(CountOf(*answer.scene, AssetKind::kBuilding), 0);
  EXPECT_EQ(CountOf(*answer.scene, AssetKind::kCrop), 0);
}

TEST(SceneTest, DeadBranchesLieBelowTrees) {
  const SceneAnswer answer = Build(Uniform(Vocabulary::kWild, 'F'), MakeEnvironment(1.0), 8);
  const std::vector<Asset> trees = OfKind(*answer.scene, AssetKind::kTree);
  for (const Asset& branch : OfKind(*answer.scene, AssetKind::kDeadBranch)) {
    EXPECT_TRUE(std::any_of(trees.begin(), trees.end(), [&branch](const Asset& tree) {
      return std::hypot(tree.x_m - branch.x_m, tree.y_m - branch.y_m) <= tree.half_length_m + 0.31;
    }));
  }
}

TEST(SceneTest, CropsStandInRowsAlongTheirField) {
  TestGround ground;
  ground.letter_at = [](WorldPoint point) {
    return std::abs(point.x_m - point.y_m) < 45.0 ? 'A' : 'G';
  };
  const SceneAnswer answer = Build(MakeTerrain(ground), MakeEnvironment(1.0), 6);
  const std::vector<Asset> crops = OfKind(*answer.scene, AssetKind::kCrop);
  ASSERT_GT(crops.size(), 1000u);
  const double direction_rad = crops[0].yaw_rad;
  EXPECT_NEAR(direction_rad, M_PI / 4.0, 0.1);
  for (const Asset& crop : crops) {
    ASSERT_EQ(crop.yaw_rad, crops[0].yaw_rad);
    const double across = -std::sin(direction_rad) * (crop.x_m - crops[0].x_m) +
                          std::cos(direction_rad) * (crop.y_m - crops[0].y_m);
    EXPECT_NEAR(std::remainder(across, 2.5), 0.0, 0.01);
  }
}

TEST(SceneTest, AssetsCarryTheVariantAndMaterialOfTheEnvironment) {
  EnvironmentConfig environment = MakeEnvironment(0.8);
  for (int type = 0; type < kAssetTypeCount; ++type) {
    const AssetTypeValues& values = ValuesOf(static_cast<AssetType>(type));
    environment.fine[type].season_variant = values.season_variants.back();
    environment.fine[type].material = values.materials[1];
  }
  for (const auto& vocabulary : EnumNames(Vocabulary{})) {
    const SceneAnswer answer = Build(MakePatchwork(vocabulary.value, 3), environment, 3);
    for (const Asset& asset : answer.scene->assets) {
      const AssetTypeValues& values = ValuesOf(TypeOf(asset.kind));
      ASSERT_EQ(asset.season_variant, values.season_variants.size() - 1);
      ASSERT_EQ(asset.material, 1);
    }
  }
}

TEST(SceneTest, AWorldOfWaterHasNoAssetsAndSaysThatNoRobotStands) {
  TestGround ground;
  ground.letter_at = [](WorldPoint) { return 'W'; };
  ground.water_at_m = [](WorldPoint) { return 5.0; };
  const SceneAnswer answer = Build(MakeTerrain(ground), MakeEnvironment(1.0), 1);
  EXPECT_TRUE(answer.scene->assets.empty());
  EXPECT_TRUE(answer.scene->agents.empty());
  ASSERT_EQ(answer.warnings.size(), 1u);
  EXPECT_NE(answer.warnings[0].find("wheeled robot"), std::string::npos) << answer.warnings[0];
}

TEST(SceneTest, StopsWhenCancelled) {
  const auto terrain = MakePatchwork(Vocabulary::kSuburb, 1);
  Progress early;
  early.Cancel();
  EXPECT_EQ(BuildScene({terrain, MakeEnvironment(0.5), 1}, early).status().code(),
            StatusCode::kCancelled);

  Progress* cancelled_midway = nullptr;
  double last = 0.0;
  Progress midway([&](std::string_view stage, double fraction) {
    EXPECT_EQ(stage, "scene");
    EXPECT_GT(fraction, last);
    last = fraction;
    if (fraction > 0.3) cancelled_midway->Cancel();
  });
  cancelled_midway = &midway;
  EXPECT_EQ(BuildScene({terrain, MakeEnvironment(0.5), 1}, midway).status().code(),
            StatusCode::kCancelled);
  EXPECT_LT(last, 0.5);
}

}  // namespace
}  // namespace latticeworld
