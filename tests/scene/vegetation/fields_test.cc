#include "latticeworld/scene/vegetation/fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "scene/test_world.h"

namespace latticeworld {
namespace {

constexpr double kDegree = M_PI / 180.0;

std::shared_ptr<const Terrain> Diagonal() {
  TestGround ground;
  ground.size_m = 512.0;
  ground.letter_at = [](WorldPoint point) {
    return std::abs(point.x_m - point.y_m) < 70.0 ? 'A' : 'G';
  };
  return MakeTerrain(ground);
}

TEST(FieldsTest, RowsRunAlongTheAreaOrAcrossIt) {
  const SceneAnswer answer = Build(Diagonal(), MakeEnvironment(1.0), 6);
  const std::vector<Asset> crops = OfKind(*answer.scene, AssetKind::kCrop);
  ASSERT_GT(crops.size(), 3000u);
  int along = 0;
  for (const Asset& crop : crops) {
    const double off = std::remainder(crop.yaw_rad - M_PI / 4.0, M_PI);
    if (std::abs(off) < 0.1) {
      ++along;
    } else {
      EXPECT_NEAR(std::abs(off), M_PI / 2.0, 0.1);
    }
  }
  EXPECT_GT(along, static_cast<int>(crops.size()) / 2);
}

// Plants of a field stand on lines 2.5 m apart.
TEST(FieldsTest, PlantsOfAFieldStandInRows) {
  const auto terrain = Diagonal();
  const EnvironmentConfig environment = MakeEnvironment(1.0);
  const Placement placement(*terrain, *Catalogue::BuiltIn(), environment, 6, 0);
  const FieldPlan plan(placement);
  ASSERT_GT(plan.fields().size(), 4u);
  int rows = 0;
  for (const Field& field : plan.fields()) {
    PointRandom random(1, 1);
    std::set<int> seen;
    for (const WorldPoint& point : RowsOf(field, terrain->geometry(), 2.5, 2.0, 0.15, &random)) {
      const double dx = point.x_m - field.centre.x_m, dy = point.y_m - field.centre.y_m;
      const double across = -std::sin(field.row_rad) * dx + std::cos(field.row_rad) * dy;
      EXPECT_NEAR(std::remainder(across, 2.5), 0.0, 1e-6);
      seen.insert(static_cast<int>(std::lround(across / 2.5)));
      EXPECT_LT(std::abs(point.x_m - point.y_m), 71.0) << "outside the farmland";
    }
    rows += static_cast<int>(seen.size());
  }
  EXPECT_GT(rows, 100);
}

TEST(FieldsTest, EachFieldHasOneCropAndMostHaveTheOneOfTheEnvironment) {
  const auto catalogue = Catalogue::BuiltIn();
  for (const char* material : {"wheat", "maize", "rapeseed", "vineyard"}) {
    EnvironmentConfig environment = MakeEnvironment(1.0);
    environment.fine_of(AssetType::kCrops).material = material;
    environment.fine_of(AssetType::kCrops).season_variant = "ripe";
    int named = 0, all = 0, kinds = 0;
    for (int seed = 0; seed < 2; ++seed) {
      const SceneAnswer answer =
          Build(MakeUniform(Vocabulary::kSuburb, 'A', 512.0), environment, seed);
      std::set<int> models;
      for (const Asset& crop : OfKind(*answer.scene, AssetKind::kCrop)) {
        ++all;
        named += catalogue->materials(AssetType::kCrops)[crop.material].name == material ? 1 : 0;
        models.insert(crop.model);
        EXPECT_TRUE(catalogue->CanBeOf(crop.model, crop.material));
      }
      kinds += static_cast<int>(models.size());
    }
    EXPECT_GT(named, all / 2) << material;
    EXPECT_GT(kinds, 2) << "other crops grow on some fields";
  }
}

// No two neighbouring plants of one crop and direction belong to fields of another kind: what
// changes is the field, not the plant.
TEST(FieldsTest, NeighboursInARowAreOfOneCrop) {
  const SceneAnswer answer = Build(MakeUniform(Vocabulary::kSuburb, 'A'), MakeEnvironment(1.0), 3);
  const std::vector<Asset> crops = OfKind(*answer.scene, AssetKind::kCrop);
  int mixed = 0, pairs = 0;
  for (std::size_t i = 1; i < crops.size(); ++i) {
    const double apart_m =
        std::hypot(crops[i].x_m - crops[i - 1].x_m, crops[i].y_m - crops[i - 1].y_m);
    if (apart_m > 4.0) continue;
    ++pairs;
    mixed += crops[i].model != crops[i - 1].model ? 1 : 0;
  }
  EXPECT_GT(pairs, 5000);
  EXPECT_LE(mixed, pairs / 500);
}

TEST(FieldsTest, VinesRunUpTheSlope) {
  TestGround ground;
  ground.size_m = 512.0;
  ground.letter_at = [](WorldPoint) { return 'A'; };
  // Rises to the north-east, about eight degrees.
  ground.height_at_m = [](WorldPoint point) { return 0.1 * (point.x_m + point.y_m); };
  EnvironmentConfig environment = MakeEnvironment(0.5);
  environment.fine_of(AssetType::kCrops).material = "vineyard";
  const SceneAnswer answer = Build(MakeTerrain(ground), environment, 4);
  const auto catalogue = Catalogue::BuiltIn();
  int vines = 0;
  for (const Asset& crop : OfKind(*answer.scene, AssetKind::kCrop)) {
    if (catalogue->models()[crop.model].shape != Shape::kVine) continue;
    ++vines;
    EXPECT_NEAR(crop.yaw_rad, 45.0 * kDegree, 1.0 * kDegree);
  }
  EXPECT_GT(vines, 500);
}

TEST(FieldsTest, OrchardsStandInRowsNearSettlementsOnly) {
  const auto catalogue = Catalogue::BuiltIn();
  TestGround ground;
  ground.size_m = 512.0;
  ground.letter_at = [](WorldPoint point) { return point.x_m < -180.0 ? 'B' : 'A'; };
  const auto terrain = MakeTerrain(ground);
  int near = 0, orchards = 0;
  for (int seed = 0; seed < 10; ++seed) {
    const EnvironmentConfig environment = MakeEnvironment(0.5);
    const Placement placement(*terrain, *catalogue, environment, seed, 0);
    const FieldPlan plan(placement);
    for (const Field& field : plan.fields()) {
      const bool in_reach = field.centre.x_m < -80.0;
      near += in_reach && std::abs(field.centre.y_m) < 250.0 ? 1 : 0;
      if (field.kind != AssetKind::kTree) continue;
      ++orchards;
      EXPECT_TRUE(in_reach);
      EXPECT_EQ(catalogue->models()[field.choice.model].name, "fruit tree");
    }
  }
  EXPECT_GT(orchards, near / 8);
  EXPECT_LT(orchards, near);
  // Their trees stand, and no crop between them.
  const SceneAnswer answer = Build(terrain, MakeEnvironment(0.5), 1);
  EXPECT_GT(CountOf(*answer.scene, AssetKind::kTree), 50);
  // A world without trees has no fruit trees: crops grow there.
  EnvironmentConfig bare = MakeEnvironment(0.5);
  bare.fine_of(AssetType::kForest).density = 0.0;
  const SceneAnswer treeless = Build(terrain, bare, 1);
  EXPECT_EQ(CountOf(*treeless.scene, AssetKind::kTree), 0);
  EXPECT_GT(CountOf(*treeless.scene, AssetKind::kCrop), CountOf(*answer.scene, AssetKind::kCrop));
}

}  // namespace
}  // namespace latticeworld
