#include "latticeworld/scene/agents/spawn_rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "geometry/in_region.h"
#include "latticeworld/geometry/region.h"
#include "latticeworld/scene/agents/spawn_site.h"
#include "scene/test_world.h"

namespace latticeworld {
namespace {

constexpr double kDegree = M_PI / 180.0;

// A scene with these assets and nothing else on it.
Scene MakeScene(const TestGround& ground, std::vector<Asset> assets = {}) {
  Scene scene;
  scene.terrain = MakeTerrain(ground);
  scene.assets = std::move(assets);
  scene.index = AssetIndex(scene.geometry().size_m(), scene.assets);
  return scene;
}

TestGround Flat() {
  TestGround ground;
  ground.letter_at = [](WorldPoint) { return 'G'; };
  return ground;
}

TestGround Sloping(double degrees) {
  TestGround ground = Flat();
  ground.height_at_m = [degrees](WorldPoint point) {
    return point.x_m * std::tan(degrees * kDegree);
  };
  return ground;
}

TestGround Flooded(double depth_m) {
  TestGround ground = Flat();
  ground.water_at_m = [depth_m](WorldPoint) { return depth_m; };
  return ground;
}

Status Check(const Scene& scene, AgentCategory category, double radius_m, WorldPoint position) {
  return CheckSpawn(scene, scene.atmosphere, category, radius_m, position);
}

Status Check(const Scene& scene, AgentCategory category, WorldPoint position) {
  return Check(scene, category, BodyRadius(category), position);
}

void ExpectRefused(const Status& status, StatusCode code, const std::string& word) {
  EXPECT_EQ(status.code(), code) << status.ToString();
  EXPECT_NE(status.message().find(word), std::string::npos) << status.message();
}

TEST(SpawnRulesTest, EveryCategoryHasABody) {
  for (const auto& category : EnumNames(AgentCategory{})) {
    EXPECT_GT(BodyRadius(category.value), 0.0);
  }
}

TEST(SpawnRulesTest, TheBodyMustBeInsideTheWorld) {
  const Scene scene = MakeScene(Flat());
  constexpr AgentCategory kRobot = AgentCategory::kWheeledRobot;
  const double inside_m = 128.0 - BodyRadius(kRobot) - 0.01;
  EXPECT_TRUE(Check(scene, kRobot, {inside_m, -inside_m}).ok());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const WorldPoint outside :
       {WorldPoint{127.9, 0.0}, WorldPoint{0.0, -128.0}, WorldPoint{1e300, 0.0},
        WorldPoint{nan, 0.0}, WorldPoint{0.0, INFINITY}}) {
    ExpectRefused(Check(scene, kRobot, outside), StatusCode::kOutOfRange, "inside the world");
  }
  for (const double radius_m : {0.0, -1.0, nan, 200.0, double{INFINITY}}) {
    ExpectRefused(Check(scene, kRobot, radius_m, {0.0, 0.0}), StatusCode::kOutOfRange,
                  "body radius");
  }
}

TEST(SpawnRulesTest, NotInOrTooNearASolidAsset) {
  Asset tree;
  tree.kind = AssetKind::kTree;
  tree.trunk_radius_m = 0.3f;
  tree.half_length_m = tree.half_width_m = 4.0f;
  Asset bush;
  bush.kind = AssetKind::kBush;
  bush.x_m = 20.0f;
  bush.half_length_m = bush.half_width_m = 1.0f;
  const Scene scene = MakeScene(Flat(), {tree, bush});
  const double reach_m = 0.3 + BodyRadius(AgentCategory::kSheep);
  ExpectRefused(Check(scene, AgentCategory::kSheep, {reach_m - 0.01, 0.0}),
                StatusCode::kFailedPrecondition, "tree at (0.00, 0.00)");
  EXPECT_TRUE(Check(scene, AgentCategory::kSheep, {reach_m + 0.01, 0.0}).ok());
  EXPECT_TRUE(Check(scene, AgentCategory::kSheep, {20.0, 0.0}).ok()) << "bushes are not solid";
  EXPECT_FALSE(Check(scene, AgentCategory::kEagle, {0.0, 0.0}).ok());
}

TEST(SpawnRulesTest, WalkersAndWheelsFordAndWhalesSwim) {
  const Scene shallow = MakeScene(Flooded(0.19)), knee = MakeScene(Flooded(0.5)),
              deep = MakeScene(Flooded(2.5));
  for (const AgentCategory category : {AgentCategory::kSheep, AgentCategory::kWheeledRobot,
                                       AgentCategory::kHumanoidRobot, AgentCategory::kGoblin}) {
    EXPECT_TRUE(Check(shallow, category, {0.0, 0.0}).ok());
    ExpectRefused(Check(knee, category, {0.0, 0.0}), StatusCode::kFailedPrecondition,
                  "water is 0.50 m deep");
  }
  ExpectRefused(Check(knee, AgentCategory::kWhale, {0.0, 0.0}), StatusCode::kFailedPrecondition,
                "needs 2 m");
  EXPECT_TRUE(Check(deep, AgentCategory::kWhale, {0.0, 0.0}).ok());
  EXPECT_TRUE(Check(deep, AgentCategory::kEagle, {0.0, 0.0}).ok());
  EXPECT_TRUE(Check(deep, AgentCategory::kAerialRobot, {0.0, 0.0}).ok());
}

TEST(SpawnRulesTest, TheWatersAreThoseOfTheMoment) {
  Atmosphere flood, drought;
  flood.water_rise_m = 0.5;
  drought.water_rise_m = -1.5;
  constexpr AgentCategory kSheep = AgentCategory::kSheep, kWhale = AgentCategory::kWhale;
  Scene shallow = MakeScene(Flooded(0.15)), deep = MakeScene(Flooded(3.0));
  RandomStream random(1, "spawn_rules_test/waters");
  const auto find = [&random](const Scene& scene, const Atmosphere& atmosphere,
                              AgentCategory category) {
    return FindSpawn(scene, atmosphere, category, 0.5, Region::kCenter, {}, &random).status();
  };
  EXPECT_TRUE(find(shallow, {}, kSheep).ok());
  ExpectRefused(find(shallow, flood, kSheep), StatusCode::kNotFound, "deeper than it can ford");
  ExpectRefused(CheckSpawn(shallow, flood, kSheep, 0.5, {0.0, 0.0}),
                StatusCode::kFailedPrecondition, "water is 0.65 m deep");
  EXPECT_TRUE(find(deep, {}, kWhale).ok());
  ExpectRefused(find(deep, drought, kWhale), StatusCode::kNotFound, "no water deep enough");
  ExpectRefused(CheckSpawn(deep, drought, kWhale, 0.5, {0.0, 0.0}), StatusCode::kFailedPrecondition,
                "water is 1.50 m deep");
  // Without a word of the weather they are the scene's.
  shallow.atmosphere = flood;
  EXPECT_FALSE(Check(shallow, kSheep, {0.0, 0.0}).ok());
  EXPECT_TRUE(CheckSpawn(MakeScene(Flat()), flood, kSheep, 0.5, {0.0, 0.0}).ok())
      << "dry land stays dry";
}

TEST(SpawnRulesTest, TheWholeBodyIsLookedAtAndNotItsCentreAlone) {
  // Beyond 10 m from the middle to one side, the ground is another.
  for (const WorldPoint side : {WorldPoint{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}) {
    const auto beyond_m = [side](WorldPoint point) {
      return side.x_m * point.x_m + side.y_m * point.y_m - 10.0;
    };
    const auto at = [side](double reach_m) {
      return WorldPoint{side.x_m * reach_m, side.y_m * reach_m};
    };
    TestGround shore = Flat(), shelf = Flat(), foot = Flat();
    shore.water_at_m = [=](WorldPoint point) { return beyond_m(point) > 0.0 ? 1.0 : NAN; };
    shelf.height_at_m = [=](WorldPoint point) { return beyond_m(point) > 0.0 ? 2.0 : 0.0; };
    shelf.water_at_m = [](WorldPoint) { return 3.0; };
    foot.height_at_m = [=](WorldPoint point) { return std::max(0.0, beyond_m(point)); };
    const Scene shore_scene = MakeScene(shore), shelf_scene = MakeScene(shelf),
                foot_scene = MakeScene(foot);
    constexpr AgentCategory kHorse = AgentCategory::kHorse, kWhale = AgentCategory::kWhale;
    EXPECT_FALSE(Check(shore_scene, kHorse, 3.0, at(8.0)).ok());
    EXPECT_TRUE(Check(shore_scene, kHorse, 3.0, at(5.0)).ok());
    EXPECT_FALSE(Check(shelf_scene, kWhale, 3.0, at(8.0)).ok());
    EXPECT_TRUE(Check(shelf_scene, kWhale, 3.0, at(5.0)).ok());
    EXPECT_FALSE(Check(foot_scene, kHorse, 3.0, at(8.0)).ok());
    EXPECT_TRUE(Check(foot_scene, kHorse, 3.0, at(5.0)).ok());
  }
}

TEST(SpawnRulesTest, SlopesAreLimitedByLocomotion) {
  const Scene steep = MakeScene(Sloping(32.0)), steeper = MakeScene(Sloping(37.0));
  ExpectRefused(Check(steep, AgentCategory::kWheeledRobot, {0.0, 0.0}),
                StatusCode::kFailedPrecondition, "32.00 degrees");
  EXPECT_TRUE(Check(steep, AgentCategory::kHorse, {0.0, 0.0}).ok());
  ExpectRefused(Check(steeper, AgentCategory::kHorse, {0.0, 0.0}), StatusCode::kFailedPrecondition,
                "at most 35");
  EXPECT_TRUE(Check(steeper, AgentCategory::kEagle, {0.0, 0.0}).ok());
}

TEST(SpawnRulesTest, WheelsHoldByTheGripOfTheirTyresSidewaysAndLegsBySpecies) {
  const double on_grass = HoldingSlope_deg(AgentCategory::kWheeledRobot, 0.6);
  EXPECT_GT(on_grass, 12.0);
  EXPECT_LT(on_grass, 20.0);
  EXPECT_LT(HoldingSlope_deg(AgentCategory::kWheeledRobot, 0.2), 0.5 * on_grass) << "on snow";
  EXPECT_EQ(HoldingSlope_deg(AgentCategory::kHorse, 0.2),
            HoldingSlope_deg(AgentCategory::kHorse, 0.9));
  for (const auto& entry : EnumNames(AgentCategory{})) {
    EXPECT_LE(HoldingSlope_deg(entry.value, 5.0), 35.0) << entry.name;
  }
}

// A slope that wheels are legal on and slide from, but for a level strip in the far west.
TEST(SpawnRulesTest, WhatMayStandAnywhereStandsWhereItHolds) {
  TestGround ground = Flat();
  ground.height_at_m = [](WorldPoint point) {
    return std::max(0.0, point.x_m + 100.0) * std::tan(25.0 * kDegree);
  };
  const Scene scene = MakeScene(ground);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RandomStream random(seed, "spawn_rules_test");
    const Result<WorldPoint> place =
        FindSpawn(scene, AgentCategory::kWheeledRobot, 0.4, Region::kAnywhere, {}, &random);
    ASSERT_TRUE(place.ok());
    EXPECT_LT(place->x_m, -99.0);
    // Where the region has no other place, it is taken.
    const Result<WorldPoint> there =
        FindSpawn(scene, AgentCategory::kWheeledRobot, 0.4, Region::kCenter, {}, &random);
    ASSERT_TRUE(there.ok()) << there.status().ToString();
    EXPECT_GT(there->x_m, -99.0);
  }
}

TEST(SpawnRulesTest, WhatIsFoundIsInItsRegionLegalAndClearOfOthers) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (const auto& vocabulary : EnumNames(Vocabulary{})) {
      const SceneAnswer answer =
          Build(MakePatchwork(vocabulary.value, seed), MakeEnvironment(1.0), seed);
      RandomStream random(seed, "spawn_rules_test");
      for (const auto& category : EnumNames(AgentCategory{})) {
        const double radius_m = BodyRadius(category.value);
        std::vector<WorldPoint> taken;
        for (const auto& region : EnumNames(Region{})) {
          const Result<WorldPoint> place =
              FindSpawn(*answer.scene, category.value, radius_m, region.value, taken, &random);
          if (!place.ok()) {
            EXPECT_EQ(place.status().code(), StatusCode::kNotFound);
            continue;
          }
          EXPECT_TRUE(Check(*answer.scene, category.value, radius_m, *place).ok());
          EXPECT_TRUE(IsIn(region.value, answer.scene->geometry(), *place));
          for (const WorldPoint& other : taken) {
            EXPECT_GE(std::hypot(other.x_m - place->x_m, other.y_m - place->y_m), 2.0 * radius_m);
          }
          taken.push_back(*place);
        }
      }
    }
  }
}

TEST(SpawnRulesTest, RobotsOnTheGroundAreDrawnOffTheOutermostCells) {
  const Scene scene = MakeScene(Flat());
  const GridGeometry& geometry = scene.geometry();
  for (const AgentCategory category :
       {AgentCategory::kWheeledRobot, AgentCategory::kRoboticDog, AgentCategory::kHumanoidRobot}) {
    const double limit_m =
        geometry.half_size_m() - geometry.resolution_m() - BodyRadius(category) + 1e-9;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      RandomStream random(seed, "spawn_rules_test/edge");
      std::vector<WorldPoint> taken;
      for (int i = 0; i < 30; ++i) {
        const auto place =
            FindSpawn(scene, category, BodyRadius(category), Region::kAnywhere, taken, &random);
        ASSERT_TRUE(place.ok()) << place.status().ToString();
        EXPECT_LE(std::max(std::abs(place->x_m), std::abs(place->y_m)), limit_m);
        taken.push_back(*place);
      }
    }
  }
}

TEST(SpawnRulesTest, FindsTheOnlyIsland) {
  // A dry disk of 3 m radius in a lake of 256 m: 0.04 % of the area.
  const WorldPoint island = {-71.0, 93.0};
  TestGround ground = Flooded(3.0);
  ground.height_at_m = [island](WorldPoint point) {
    return std::hypot(point.x_m - island.x_m, point.y_m - island.y_m) < 3.0 ? 4.0 : 0.0;
  };
  ground.cells = 512;
  // Its shore is a cliff, so the body stands well inside.
  const Scene scene = MakeScene(ground);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RandomStream random(seed, "spawn_rules_test/island");
    const Result<WorldPoint> place =
        FindSpawn(scene, AgentCategory::kSheep, 0.5, Region::kAnywhere, {}, &random);
    ASSERT_TRUE(place.ok()) << place.status().ToString();
    EXPECT_LT(std::hypot(place->x_m - island.x_m, place->y_m - island.y_m), 3.0);
  }
}

TEST(SpawnRulesTest, NoPlaceSaysWhy) {
  RandomStream random(1, "spawn_rules_test");
  const Result<WorldPoint> whale =
      FindSpawn(MakeScene(Flat()), AgentCategory::kWhale, 3.0, Region::kLower, {}, &random);
  ExpectRefused(whale.status(), StatusCode::kNotFound, "no water deep enough (at least 2 m)");
  EXPECT_NE(whale.status().message().find("region lower"), std::string::npos);
  const Result<WorldPoint> sheep =
      FindSpawn(MakeScene(Sloping(50.0)), AgentCategory::kSheep, 0.5, Region::kCenter, {}, &random);
  ExpectRefused(sheep.status(), StatusCode::kNotFound, "too steep (at most 35 degrees)");
  const Result<WorldPoint> giant =
      FindSpawn(MakeScene(Flat()), AgentCategory::kHorse, 500.0, Region::kCenter, {}, &random);
  ExpectRefused(giant.status(), StatusCode::kNotFound, "does not fit");
}

TEST(SpawnRulesTest, SheepPreferGrass) {
  TestGround ground = Flat();
  ground.letter_at = [](WorldPoint point) { return point.x_m > 60.0 ? 'G' : 'D'; };
  const Scene scene = MakeScene(ground);
  RandomStream random(1, "spawn_rules_test/grass");
  for (int i = 0; i < 50; ++i) {
    const Result<WorldPoint> place =
        FindSpawn(scene, AgentCategory::kSheep, 0.5, Region::kAnywhere, {}, &random);
    ASSERT_TRUE(place.ok());
    EXPECT_GT(place->x_m, 59.0);
  }
}

}  // namespace
}  // namespace latticeworld
