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
#include "latticeworld/scene/footprint.h"
#include "latticeworld/scene/placement.h"
#include "latticeworld/scene/settlements/settlement_rules.h"
#include "latticeworld/scene/vegetation/densities.h"
#include "scene/test_world.h"

namespace latticeworld {
namespace {

constexpr int kSeeds = 20;

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
    // Nobody else's solid part, buildings' gap included, and no ground cover in a solid.
    const bool building = asset.kind == AssetKind::kBuilding;
    scene.index.ForEachNear(
        asset.position(), radius_m + (building ? kLeastWallGap_m : 0.0), [&](std::uint32_t j) {
          if (j == i) return;
          const Asset& other = scene.assets[j];
          if (!IsSolid(asset.kind)) {
            ASSERT_FALSE(SolidContains(other, asset.position(), 0.0));
          } else if (building && other.kind == AssetKind::kBuilding) {
            // The houses of a terrace touch.
            const double gap_m = GapBetween(FootprintOf(asset), FootprintOf(other));
            ASSERT_TRUE(gap_m >= kLeastWallGap_m - 1e-3 || std::abs(gap_m) < 0.02) << gap_m;
          } else if (building || other.kind == AssetKind::kBuilding) {
            const Asset& round = building ? other : asset;
            ASSERT_FALSE(SolidContains(building ? asset : other, round.position(),
                                       SolidRadius(round) - 1e-3));
          } else {
            ASSERT_GE(std::hypot(other.x_m - asset.x_m, other.y_m - asset.y_m) - radius_m -
                          SolidRadius(other),
                      -1e-3);
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
    const auto terrain = MakeUniform(item.vocabulary, item.letter);
    for (const double density : {0.0, 0.3, 1.0}) {
      const SceneAnswer answer = Build(terrain, MakeEnvironment(density), 5);
      const double expected =
          Catalogue::BuiltIn()->PerHectare(item.kind, NameOf(item.vocabulary), item.letter) *
          density * 6.5536;  // hectares
      EXPECT_NEAR(CountOf(*answer.scene, item.kind), expected,
                  0.1 * expected + 2.0 * std::sqrt(expected))
          << NameOf(item.kind) << " at " << density;
    }
  }
}

TEST(SceneTest, NoHectareHoldsMoreThanAWorldCanBear) {
  constexpr double kMostPerHectare = 2000.0;
  for (const auto& vocabulary : EnumNames(Vocabulary{})) {
    for (const LayoutClass& item : ClassesOf(vocabulary.value)) {
      double sum = 0.0;
      for (const auto& kind : EnumNames(AssetKind{})) {
        sum += Catalogue::BuiltIn()->PerHectare(kind.value, vocabulary.name, item.letter);
      }
      EXPECT_LE(sum, kMostPerHectare) << item.letter;
    }
  }
}

TEST(SceneTest, LargeWorldsAreThinnedToTheLimitAndSaySo) {
  const auto terrain = MakeUniform(Vocabulary::kSuburb, 'G', 2048.0);
  const SceneAnswer answer = Build(terrain, MakeEnvironment(1.0), 1);
  EXPECT_LE(static_cast<int>(answer.scene->assets.size()), kMaxAssets);
  EXPECT_GT(static_cast<int>(answer.scene->assets.size()), kMaxAssets / 2);
  ASSERT_FALSE(answer.warnings.empty());
  EXPECT_NE(answer.warnings[0].find("thinned"), std::string::npos) << answer.warnings[0];
}

TEST(SceneTest, WildWorldsHaveNoBuildingsOrCrops) {
  const SceneAnswer answer = Build(MakePatchwork(Vocabulary::kWild, 1), MakeEnvironment(1.0), 1);
  EXPECT_EQ(CountOf(*answer.scene, AssetKind::kBuilding), 0);
  EXPECT_EQ(CountOf(*answer.scene, AssetKind::kCrop), 0);
}

TEST(SceneTest, DeadBranchesLieBelowTrees) {
  const SceneAnswer answer = Build(MakeUniform(Vocabulary::kWild, 'F'), MakeEnvironment(1.0), 8);
  const std::vector<Asset> trees = OfKind(*answer.scene, AssetKind::kTree);
  for (const Asset& branch : OfKind(*answer.scene, AssetKind::kDeadBranch)) {
    EXPECT_TRUE(std::any_of(trees.begin(), trees.end(), [&branch](const Asset& tree) {
      return std::hypot(tree.x_m - branch.x_m, tree.y_m - branch.y_m) <= tree.half_length_m + 0.31;
    }));
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
  EXPECT_EQ(BuildScene(MakeRequest(terrain, MakeEnvironment(0.5), 1), early).status().code(),
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
  EXPECT_EQ(BuildScene(MakeRequest(terrain, MakeEnvironment(0.5), 1), midway).status().code(),
            StatusCode::kCancelled);
  EXPECT_LT(last, 0.5);
}

}  // namespace
}  // namespace latticeworld
