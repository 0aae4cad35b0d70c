#include "latticeworld/scene/props/things.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "latticeworld/layout/thing_kinds.h"
#include "latticeworld/layout/thing_wishes.h"
#include "latticeworld/layout/zone.h"
#include "latticeworld/scene/asset_physics.h"
#include "latticeworld/scene/footprint.h"
#include "latticeworld/scene/props/thing_claims.h"
#include "latticeworld/scene/props/thing_maker.h"
#include "scene/test_world.h"

namespace latticeworld {
namespace {

// A village in the west with a stream, a road from north to south, a lake in the east, meadows
// between.
std::shared_ptr<const Terrain> MakeLand() {
  const auto is_wet = [](WorldPoint point) {
    return std::hypot(point.x_m - 80.0, point.y_m) < 25.0 || std::abs(point.x_m + 112.0) < 3.0;
  };
  TestGround ground;
  ground.letter_at = [=](WorldPoint point) {
    if (is_wet(point)) return 'W';
    if (point.x_m < -60.0) return 'B';
    return std::abs(point.x_m - 20.0) < 3.0 ? 'R' : 'G';
  };
  ground.height_at_m = [=](WorldPoint point) { return is_wet(point) ? -1.0 : 0.5; };
  ground.water_at_m = [=](WorldPoint point) { return is_wet(point) ? 0.0 : double{NAN}; };
  return MakeTerrain(ground);
}

ThingWish Wish(const std::string& kind, int count = 1) {
  ThingWish wish;
  wish.kind = kind;
  wish.count = wish.count_least = wish.count_most = count;
  return wish;
}

SceneAnswer BuildWith(const std::vector<ThingWish>& wishes, std::uint64_t seed) {
  SceneRequest request = MakeRequest(MakeLand(), MakeEnvironment(0.5), seed);
  request.things = wishes;
  auto answer = BuildScene(request, Progress());
  EXPECT_TRUE(answer.ok()) << answer.status().ToString();
  return *answer;
}

void ExpectAllHold(const SceneAnswer& answer, const std::vector<ThingWish>& wishes) {
  for (const ThingOutcome& outcome : MeasureThings(*answer.scene, wishes)) {
    EXPECT_TRUE(outcome.holds) << outcome.kind << ": " << outcome.explanation;
  }
}

TEST(ThingsTest, ARowOfTreesStandsInOneLineBesideTheVillageForAnySeed) {
  ThingWish row = Wish("tree", 3);
  row.arrangement = ThingArrangement::kRow;
  row.spacing_m = 7.0;
  row.relation = ThingRelation::kNear;
  row.target.letter = 'B';
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    const SceneAnswer answer = BuildWith({row}, seed);
    ASSERT_EQ(answer.scene->things.size(), 3u);
    for (const SceneThing& thing : answer.scene->things) {
      EXPECT_EQ(answer.scene->assets[thing.asset].kind, AssetKind::kTree);
    }
    ExpectAllHold(answer, {row});
  }
}

// By the geometry itself, not by the claims: the lake is round, 25 m around (80, 0).
TEST(ThingsTest, ThingsStandOnTheSideOfALakeAndOfAThingThatIsAsked) {
  const ThingSide sides[] = {ThingSide::kNorth, ThingSide::kSouthWest, ThingSide::kWest};
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    for (const ThingSide side : sides) {
      SCOPED_TRACE(std::string(NameOf(side)) + " with seed " + std::to_string(seed));
      std::vector<ThingWish> wishes = {Wish("tower"), Wish("bench", 2)};
      wishes[0].relation = wishes[1].relation = ThingRelation::kNear;
      wishes[0].side = wishes[1].side = side;
      wishes[0].target.letter = 'W';
      wishes[0].zone = *FindZone("eastern half");
      wishes[1].target.wish = 0;
      wishes[1].distance_m = 12.0;
      const SceneAnswer answer = BuildWith(wishes, seed);
      ASSERT_EQ(answer.scene->things.size(), 3u);
      const auto off_rad = [&](WorldPoint from, WorldPoint to) {
        const double heading_rad = std::atan2(to.y_m - from.y_m, to.x_m - from.x_m);
        return std::abs(std::remainder(heading_rad - HeadingOf(side), 2.0 * M_PI));
      };
      const WorldPoint tower = answer.scene->things[0].position;
      EXPECT_LE(off_rad({80.0, 0.0}, tower), M_PI / 2.0);
      EXPECT_GT(std::hypot(tower.x_m - 80.0, tower.y_m), 25.0);
      for (std::size_t i = 1; i < 3; ++i)
        EXPECT_LE(off_rad(tower, answer.scene->things[i].position), M_PI / 4.0);
      ExpectAllHold(answer, wishes);
    }
  }
}

TEST(ThingsTest, AWellBetweenTheVillageAndTheRoadStandsBetweenThem) {
  ThingWish well = Wish("well");
  well.relation = ThingRelation::kBetween;
  well.target.letter = 'B';
  well.second.letter = 'R';
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const SceneAnswer answer = BuildWith({well}, seed);
    ASSERT_EQ(answer.scene->things.size(), 1u);
    const double x_m = answer.scene->things[0].position.x_m;
    EXPECT_GT(x_m, -60.0) << "the village's edge";
    EXPECT_LT(x_m, 17.0) << "the road's";
    ExpectAllHold(answer, {well});
  }
}

// The road from north to south lies half way between the towers.
TEST(ThingsTest, WhatIsBetweenTwoThingsStandsBesideARoadInTheirMidst) {
  std::vector<ThingWish> wishes = {Wish("tower"), Wish("tower"), Wish("well")};
  wishes[0].position = WorldPoint{0.0, 0.0};
  wishes[1].position = WorldPoint{40.0, 0.0};
  wishes[2].relation = ThingRelation::kBetween;
  wishes[2].target.wish = 0;
  wishes[2].second.wish = 1;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const SceneAnswer answer = BuildWith(wishes, seed);
    ASSERT_EQ(answer.scene->things.size(), 3u);
    const WorldPoint well = answer.scene->things[2].position;
    EXPECT_GT(std::abs(well.x_m - 20.0), 3.0) << "half the road's width";
    EXPECT_LT(std::hypot(well.x_m - 20.0, well.y_m), 20.0);
    ExpectAllHold(answer, wishes);
  }
}

TEST(ThingsTest, ABenchBetweenLampsStandsBetweenTwoOfThem) {
  std::vector<ThingWish> wishes = {Wish("lamp", 3), Wish("bench")};
  wishes[0].arrangement = ThingArrangement::kRow;
  wishes[0].spacing_m = 12.0;
  wishes[1].relation = ThingRelation::kBetween;
  wishes[1].target.wish = wishes[1].second.wish = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const SceneAnswer answer = BuildWith(wishes, seed);
    ASSERT_EQ(answer.scene->things.size(), 4u);
    const WorldPoint bench = answer.scene->things[3].position;
    double nearest_m = 1e9;
    for (int i = 0; i < 2; ++i) {
      const WorldPoint a = answer.scene->things[static_cast<std::size_t>(i)].position;
      const WorldPoint b = answer.scene->things[static_cast<std::size_t>(i) + 1].position;
      nearest_m = std::min(nearest_m, std::hypot(0.5 * (a.x_m + b.x_m) - bench.x_m,
                                                 0.5 * (a.y_m + b.y_m) - bench.y_m));
    }
    EXPECT_LT(nearest_m, 5.0) << "from the middle of two that are 12 m apart";
    ExpectAllHold(answer, wishes);
  }
}

TEST(ThingsTest, TwoTowersAroundAGateStandToItsLeftAndToItsRight) {
  std::vector<ThingWish> wishes = {Wish("gate"), Wish("tower", 2)};
  wishes[0].position = WorldPoint{-20.0, 10.0};
  wishes[0].heading_rad = 0.5;
  wishes[1].relation = ThingRelation::kAround;
  wishes[1].target.wish = 0;
  const SceneAnswer answer = BuildWith(wishes, 1);
  ASSERT_EQ(answer.scene->things.size(), 3u);
  double left_m = 1.0;
  for (std::size_t i = 1; i < 3; ++i) {
    const WorldPoint tower = answer.scene->things[i].position;
    const double dx_m = tower.x_m + 20.0, dy_m = tower.y_m - 10.0;
    EXPECT_NEAR(dx_m * std::cos(0.5) + dy_m * std::sin(0.5), 0.0, 1.0)
        << "neither before nor behind";
    left_m *= dy_m * std::cos(0.5) - dx_m * std::sin(0.5);
  }
  EXPECT_LT(left_m, 0.0) << "on two sides";
  ExpectAllHold(answer, wishes);
}

TEST(ThingsTest, ABuildingInAVillageTakesThePlaceOfAHouse) {
  ThingWish church = Wish("church");
  church.relation = ThingRelation::kIn;
  church.target.letter = 'B';
  std::vector<ThingWish> wishes = {church, church, Wish("bench")};
  wishes[1].kind = "tower";
  wishes[2].relation = ThingRelation::kBehind;
  wishes[2].target.wish = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const SceneAnswer answer = BuildWith(wishes, seed);
    ASSERT_EQ(answer.scene->things.size(), 3u);
    const auto at = [&](std::size_t i) { return answer.scene->things[i].position; };
    EXPECT_LT(at(0).x_m, -50.0) << "10 m from the village's edge";
    EXPECT_LT(at(1).x_m, -50.0);
    const double yaw_rad = answer.scene->things[0].yaw_rad;
    EXPECT_LT(
        (at(2).x_m - at(0).x_m) * std::cos(yaw_rad) + (at(2).y_m - at(0).y_m) * std::sin(yaw_rad),
        0.0)
        << "the bench stands before the church";
    ExpectAllHold(answer, wishes);
  }
}

TEST(ThingsTest, ARowInALongZoneLiesAlongIt) {
  ThingWish row = Wish("tree", 4);
  row.arrangement = ThingArrangement::kRow;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    for (const bool north_south : {true, false}) {
      SCOPED_TRACE(seed);
      row.zone = *FindZone(north_south ? "eastern edge" : "northern edge");
      const SceneAnswer answer = BuildWith({row}, seed);
      ASSERT_EQ(answer.scene->things.size(), 4u);
      const WorldPoint first = answer.scene->things.front().position;
      const WorldPoint last = answer.scene->things.back().position;
      const double across_m = north_south ? last.x_m - first.x_m : last.y_m - first.y_m;
      EXPECT_NEAR(across_m, 0.0, 0.5);
    }
  }
}

// The stream in the west and the lake in the east.
TEST(ThingsTest, ATentBetweenTheWatersHasOneOfThemOnEitherSide) {
  ThingWish tent = Wish("tent");
  tent.relation = ThingRelation::kBetween;
  tent.target.letter = tent.second.letter = 'W';
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const SceneAnswer answer = BuildWith({tent}, seed);
    ASSERT_EQ(answer.scene->things.size(), 1u);
    EXPECT_NEAR(answer.scene->things[0].position.x_m, -27.0, 30.0);
    ExpectAllHold(answer, {tent});
  }
}

TEST(ThingsTest, AClaimOfASideFailsForWhatStandsOnTheOther) {
  ThingWish tower = Wish("tower");
  tower.relation = ThingRelation::kNear;
  tower.target.letter = 'R';
  tower.side = ThingSide::kEast;
  const SceneAnswer answer = BuildWith({tower}, 1);
  tower.side = ThingSide::kWest;
  const std::vector<ThingOutcome> outcomes = MeasureThings(*answer.scene, {tower});
  ASSERT_EQ(outcomes.size(), 2u);
  EXPECT_EQ(std::string(outcomes[1].kind), "thing_direction");
  EXPECT_FALSE(outcomes[1].holds);
}

TEST(ThingsTest, BenchesAroundAWellInFrontOfAChurchAndLampsAlongTheRoadKeepToTheirRelations) {
  std::vector<ThingWish> wishes = {Wish("church"), Wish("well"), Wish("bench", 4), Wish("lamp", 6)};
  wishes[1].relation = ThingRelation::kInFront;
  wishes[1].target.wish = 0;
  wishes[2].relation = ThingRelation::kAround;
  wishes[2].target.wish = 1;
  wishes[3].arrangement = ThingArrangement::kRow;
  wishes[3].relation = ThingRelation::kAlong;
  wishes[3].target.letter = 'R';
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const SceneAnswer answer = BuildWith(wishes, seed);
    EXPECT_EQ(answer.scene->things.size(), 12u);
    ExpectAllHold(answer, wishes);
  }
}

TEST(ThingsTest, NothingOverlapsSolidsRoadsOrWater) {
  std::vector<ThingWish> wishes = {Wish("boulder", 6), Wish("hut", 4), Wish("fence", 5),
                                   Wish("crate", 6)};
  wishes[1].arrangement = ThingArrangement::kGrid;
  wishes[2].arrangement = ThingArrangement::kRow;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const SceneAnswer answer = BuildWith(wishes, seed);
    const Scene& scene = *answer.scene;
    for (const SceneThing& thing : scene.things) {
      EXPECT_NE(scene.terrain->SurfaceAt(thing.position), SurfaceClass::kRoad) << thing.name;
      EXPECT_EQ(scene.terrain->WaterDepthAt(thing.position), 0.0) << thing.name;
      for (std::size_t i = 0; i < scene.assets.size(); ++i) {
        if (static_cast<std::int32_t>(i) == thing.asset) continue;
        EXPECT_FALSE(SolidContains(scene.assets[i], thing.position, 0.0)) << thing.name;
      }
    }
  }
}

TEST(ThingsTest, AnExactPlaceIsKeptAndHousesMakeRoom) {
  const SceneAnswer without = BuildWith({}, 3);
  const std::vector<Asset> houses = OfKind(*without.scene, AssetKind::kBuilding);
  ASSERT_FALSE(houses.empty());
  ThingWish bench = Wish("bench");
  bench.name = "b1";
  bench.position = houses.front().position();
  bench.heading_rad = 1.0;
  const SceneAnswer answer = BuildWith({bench}, 3);
  ASSERT_EQ(answer.scene->things.size(), 1u);
  EXPECT_EQ(answer.scene->things[0].name, "b1");
  EXPECT_NEAR(answer.scene->things[0].position.x_m, bench.position->x_m, 1e-4);
  EXPECT_NEAR(answer.scene->things[0].yaw_rad, 1.0, 1e-6);
  EXPECT_LT(CountOf(*answer.scene, AssetKind::kBuilding), static_cast<int>(houses.size()) + 1);
}

TEST(ThingsTest, WhatCannotStandIsAWarningWithTheReasonAndAClaimThatDoesNotHold) {
  ThingWish bench = Wish("bench");
  bench.position = WorldPoint{80.0, 0.0};  // in the lake
  const SceneAnswer answer = BuildWith({bench}, 1);
  EXPECT_TRUE(answer.scene->things.empty());
  ASSERT_FALSE(answer.warnings.empty());
  bool said = false;
  for (const std::string& warning : answer.warnings) {
    said = said || warning.find("there is water") != std::string::npos;
  }
  EXPECT_TRUE(said);
  EXPECT_FALSE(MeasureThings(*answer.scene, {bench}).front().holds);
}

TEST(ThingsTest, ManyThousandsAreCutToTheLimitAndSaid) {
  ThingWish row = Wish("post", 10000);
  row.arrangement = ThingArrangement::kRow;
  const SceneAnswer answer = BuildWith({row}, 1);
  EXPECT_LE(answer.scene->things.size(), static_cast<std::size_t>(kMostThings));
  ASSERT_FALSE(answer.warnings.empty());
  EXPECT_NE(answer.warnings.front().find("at most 500"), std::string::npos)
      << answer.warnings.front();
}

TEST(ThingsTest, EveryKindCanStand) {
  for (const ThingKind& kind : AllThingKinds()) {
    SCOPED_TRACE(kind.name);
    ThingWish wish = Wish(kind.name);
    if (kind.name == "pier") {
      wish.relation = ThingRelation::kNear;
      wish.target.letter = 'W';
    }
    const SceneAnswer answer = BuildWith({wish}, 5);
    ASSERT_EQ(answer.scene->things.size(), 1u);
    const SceneThing& thing = answer.scene->things[0];
    EXPECT_EQ(thing.asset < 0, kind.source == ThingSource::kProp);
  }
}

TEST(ThingsTest, AFenceAlongTheRoadIsOneLineWhosePiecesMeet) {
  ThingWish fence = Wish("fence");
  fence.relation = ThingRelation::kAlong;
  fence.target.letter = 'R';
  FillRun(&fence);
  const SceneAnswer answer = BuildWith({fence}, 2);
  const std::vector<SceneThing>& pieces = answer.scene->things;
  ASSERT_GT(pieces.size(), 15u);
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const double apart_m = std::hypot(pieces[i].position.x_m - pieces[i - 1].position.x_m,
                                      pieces[i].position.y_m - pieces[i - 1].position.y_m);
    EXPECT_NEAR(apart_m, 6.2, 0.3) << i;
    const double turn_rad = std::remainder(pieces[i].yaw_rad - pieces[i - 1].yaw_rad, 2.0 * M_PI);
    EXPECT_LT(std::abs(turn_rad), 0.4) << i;
  }
}

TEST(ThingsTest, TreesOfARowAreOfOneKindAndTheirCrownsOnlyMeet) {
  ThingWish row = Wish("tree", 6);
  row.arrangement = ThingArrangement::kRow;
  row.spacing_m = 7.0;
  const SceneAnswer answer = BuildWith({row}, 4);
  ASSERT_EQ(answer.scene->things.size(), 6u);
  const Asset& first = answer.scene->assets[answer.scene->things[0].asset];
  for (const SceneThing& thing : answer.scene->things) {
    const Asset& tree = answer.scene->assets[thing.asset];
    EXPECT_EQ(tree.model, first.model);
    EXPECT_LE(2.0 * tree.half_length_m, 7.0);
    EXPECT_NEAR(tree.height_m / first.height_m, 1.0, 0.12);
  }
}

TEST(ThingsTest, AWallIsABoxThatBodiesBumpIntoAndATreeFallsWhenHit) {
  const SceneAnswer answer = BuildWith({Wish("wall"), Wish("oak")}, 2);
  ASSERT_EQ(answer.scene->things.size(), 2u);
  const Scene& scene = *answer.scene;
  const AssetPhysics wall = PhysicsOf(*scene.catalogue, scene.assets[scene.things[0].asset]);
  EXPECT_EQ(wall.collision.form, Collision::kBox);
  EXPECT_NEAR(wall.collision.half_width_m, 3.0, 1e-5);
  EXPECT_TRUE(std::isinf(wall.failing_moment_nm()));
  const AssetPhysics oak = PhysicsOf(*scene.catalogue, scene.assets[scene.things[1].asset]);
  EXPECT_EQ(oak.collision.form, Collision::kTrunk);
  EXPECT_TRUE(std::isfinite(oak.failing_moment_nm()));
}

TEST(ThingsTest, TheSameRequestGivesTheSameThingsAndNoThingsChangeNothing) {
  const std::vector<ThingWish> wishes = {Wish("tree", 5), Wish("bench", 3)};
  const SceneAnswer one = BuildWith(wishes, 4), other = BuildWith(wishes, 4);
  EXPECT_TRUE(SameBytes(one.scene->assets, other.scene->assets));
  const SceneAnswer plain = BuildWith({}, 4);
  const SceneAnswer usual = Build(MakeLand(), MakeEnvironment(0.5), 4);
  EXPECT_TRUE(SameBytes(plain.scene->assets, usual.scene->assets));
}

TEST(ThingClaimsTest, ARowThatIsBentDoesNotHold) {
  ThingWish row = Wish("post", 3);
  row.arrangement = ThingArrangement::kRow;
  row.spacing_m = 5.0;
  Scene scene;
  scene.terrain = MakeLand();
  for (const WorldPoint place : {WorldPoint{0, 0}, WorldPoint{5, 2}, WorldPoint{10, 0}}) {
    scene.things.push_back({"post", "post", 0, -1, place, 0.0});
  }
  const std::vector<ThingOutcome> outcomes = MeasureThings(scene, {row});
  ASSERT_EQ(outcomes.size(), 3u);
  EXPECT_TRUE(outcomes[0].holds);
  EXPECT_EQ(outcomes[1].kind, "thing_row");
  EXPECT_FALSE(outcomes[1].holds);
  EXPECT_EQ(outcomes[2].kind, "thing_spacing");
}

}  // namespace
}  // namespace latticeworld
