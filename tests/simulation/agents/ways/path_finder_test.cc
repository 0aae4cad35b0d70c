#include "latticeworld/simulation/agents/ways/path_finder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/simulation/agents/ways/solid_clearance.h"
#include "latticeworld/simulation/agents/ways/steering.h"
#include "latticeworld/species/species_catalogue.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

const Species& Of(const std::string& name) {
  const Species* const species = SpeciesCatalogue::BuiltIn()->Find(name);
  EXPECT_NE(species, nullptr) << name;
  return *species;
}

TestScene Forest(int trees, std::uint64_t seed) {
  TestScene scene;
  RandomStream random(seed, "trees");
  for (int i = 0; i < trees; ++i)
    scene.AddTree(random.Uniform(-30.0, 30.0), random.Uniform(-30.0, 30.0),
                  random.Uniform(0.1, 0.4));
  return scene;
}

FallenTree Lying(const Scene& scene, std::uint32_t asset, double heading_rad) {
  const Asset& tree = scene.assets[asset];
  const Eigen::Vector3d foot(tree.x_m, tree.y_m, tree.z_m + tree.trunk_radius_m);
  const Eigen::Vector3d way(std::cos(heading_rad), std::sin(heading_rad), 0.0);
  return {asset, foot, foot + tree.height_m * way};
}

// Whether nothing solid comes nearer than the body's radius anywhere along the way.
bool IsClear(const Scene& scene, const SceneChanges& changes, const Species& species,
             WorldPoint from, const FoundPath& path) {
  for (const WorldPoint point : path.points) {
    if (!IsWayClear(scene, changes, from, point, species.radius_m, species.height_m)) return false;
    from = point;
  }
  return true;
}

// A place where the species can be, the first on growing rings around a point. False: none lies
// within radius_m.
bool FreePlaceNear(PathFinder* paths, const Species& species, WorldPoint near, double radius_m,
                   WorldPoint* place) {
  constexpr int kDirections = 16;
  for (double ring_m = 0.0; ring_m <= radius_m; ring_m += 0.5) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2.0 * M_PI * i / kDirections;
      *place = {near.x_m + ring_m * std::cos(angle), near.y_m + ring_m * std::sin(angle)};
      if (paths->IsStraightFree(species, *place, *place)) return true;
    }
  }
  return false;
}

TEST(PathFinderTest, OverOpenGroundItIsTheStraightWay) {
  const auto scene = TestScene().Build();
  PathFinder paths(*scene);
  const FoundPath path = paths.Find(Of("goblin"), {-20.0, -5.0}, {25.0, 13.0});
  ASSERT_EQ(path.points.size(), 1u);
  EXPECT_TRUE(path.complete);
  EXPECT_EQ(path.points[0].x_m, 25.0);
  EXPECT_DOUBLE_EQ(path.length_m, std::hypot(45.0, 18.0));
}

TEST(PathFinderTest, GoesAroundAWallByTheShorterSide) {
  TestScene made;
  made.AddBuilding(0.0, 4.0, 0.5, 14.0);  // from y = -10 to 18
  const auto scene = made.Build();
  PathFinder paths(*scene);
  const Species& goblin = Of("goblin");
  const FoundPath path = paths.Find(goblin, {-10.0, 0.0}, {10.0, 0.0});
  ASSERT_TRUE(path.complete);
  EXPECT_FALSE(paths.IsStraightFree(goblin, {-10.0, 0.0}, {10.0, 0.0}));
  EXPECT_TRUE(IsClear(*scene, {}, goblin, {-10.0, 0.0}, path));
  // Around the corners at (-+0.5, -10), each at the body's radius.
  const double shortest_m = 2.0 * std::hypot(9.5 - goblin.radius_m, 10.0 + goblin.radius_m);
  EXPECT_GE(path.length_m, shortest_m);
  EXPECT_LE(path.length_m, 1.15 * shortest_m);
  for (const WorldPoint point : path.points) EXPECT_LT(point.y_m, 1.0);
}

TEST(PathFinderTest, WaysThroughForestsTouchNothingAndAreNoDetours) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto scene = Forest(150, seed).Build();
    PathFinder paths(*scene);
    RandomStream random(seed, "ends");
    for (const char* name : {"goblin", "sheep", "robotic dog"}) {
      const Species& species = Of(name);
      WorldPoint from, to;
      if (!FreePlaceNear(&paths, species, {random.Uniform(-28.0, 28.0), -28.0}, 8.0, &from) ||
          !FreePlaceNear(&paths, species, {random.Uniform(-28.0, 28.0), 28.0}, 8.0, &to))
        continue;
      const FoundPath path = paths.Find(species, from, to, 100000);
      if (!path.complete) continue;
      ++found;
      EXPECT_TRUE(IsClear(*scene, {}, species, from, path)) << name << ", seed " << seed;
      double length_m = 0.0;
      WorldPoint last = from;
      for (const WorldPoint point : path.points) {
        length_m += DistanceBetween(last, point);
        last = point;
      }
      EXPECT_NEAR(length_m, path.length_m, 1e-9);
      EXPECT_LT(DistanceBetween(last, to), 1e-9);
      EXPECT_LT(path.length_m, 1.35 * DistanceBetween(from, to)) << name << ", seed " << seed;
    }
  }
  EXPECT_GT(found, 40);
}

TEST(PathFinderTest, WhereItLeadsTheTraversabilityMapLetsTheBodyPass) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    TestScene made = Forest(100, seed);
    made.height_m = Hills(4.0, 30.0);
    const auto scene = made.Build();
    PathFinder paths(*scene);
    const Species& species = Of("robotic dog");
    WorldPoint from, to;
    ASSERT_TRUE(FreePlaceNear(&paths, species, {-25.0, -25.0}, 10.0, &from));
    ASSERT_TRUE(FreePlaceNear(&paths, species, {25.0, 25.0}, 10.0, &to));
    const FoundPath path = paths.Find(species, from, to, 100000);
    RobotLimits limits;
    limits.radius_m = species.radius_m;
    limits.max_slope_rad = species.max_slope_rad;
    limits.max_fording_depth_m = species.wade_depth_m;
    limits.clearance_m = 0.0;
    limits.grip = species.grip;
    limits.on_wheels = false;
    const Grid<float> map = BuildTraversability(*scene, limits);
    for (const WorldPoint point : path.points) {
      const double length_m = DistanceBetween(from, point);
      for (double s = 0.0; s <= length_m; s += 0.1) {
        const WorldPoint place = Ahead(from, HeadingTo(from, point), s);
        EXPECT_GT(map[scene->geometry().CellAt(place)], 0.0f)
            << "seed " << seed << " at " << place.x_m << " " << place.y_m;
      }
      from = point;
    }
  }
}

TEST(PathFinderTest, AHorseFordsWhereADogHasToGoAround) {
  TestScene made;
  // A river along x = 0, 0.4 m deep, with a ford of 0.1 m at y > 20.
  made.water_depth_m = [](double x, double y) {
    return std::abs(x) < 3.0 ? (y > 20.0 ? 0.1 : 0.4) : 0.0;
  };
  const auto scene = made.Build();
  PathFinder paths(*scene);
  const WorldPoint from{-10.0, 0.0}, to{10.0, 0.0};
  EXPECT_TRUE(paths.IsStraightFree(Of("horse"), from, to));
  EXPECT_FALSE(paths.IsStraightFree(Of("robotic dog"), from, to));
  const FoundPath dog = paths.Find(Of("robotic dog"), from, to);
  ASSERT_TRUE(dog.complete);
  EXPECT_GT(dog.length_m, 2.0 * std::hypot(7.0, 20.0));
  const FoundPath horse = paths.Find(Of("horse"), from, to);
  EXPECT_DOUBLE_EQ(horse.length_m, 20.0);
}

TEST(PathFinderTest, SwimmersKeepToDeepWater) {
  TestScene made;
  made.size_m = 128.0;
  // A lake with a shallow bar that leaves a gap in the north.
  made.water_depth_m = [](double x, double y) {
    if (std::abs(x) > 55.0 || std::abs(y) > 55.0) return 0.0;
    return std::abs(x) < 5.0 && y < 25.0 ? 1.0 : 8.0;
  };
  const auto scene = made.Build();
  PathFinder paths(*scene);
  const FoundPath path = paths.Find(Of("whale"), {-30.0, -20.0}, {30.0, -20.0}, 20000);
  ASSERT_TRUE(path.complete);
  WorldPoint from{-30.0, -20.0};
  for (const WorldPoint point : path.points) {
    for (double s = 0.0; s <= DistanceBetween(from, point); s += 0.5)
      EXPECT_GE(scene->terrain->WaterDepthAt(Ahead(from, HeadingTo(from, point), s)), 2.0);
    from = point;
  }
  EXPECT_FALSE(paths.Find(Of("whale"), {-30.0, -20.0}, {60.0, 0.0}, 20000).complete);
}

TEST(PathFinderTest, SlopesThatFeetDoNotHoldOnAreNoWay) {
  TestScene made;
  made.height_m = [](double x, double) { return std::max(0.0, 0.45 * x); };  // 24 degrees
  const auto dry = made.Build();
  made.surface = [](double x, double) {
    return x > 0.0 ? SurfaceClass::kSnow : SurfaceClass::kGrass;
  };
  const auto snowy = made.Build();
  const Species& goblin = Of("goblin");
  EXPECT_TRUE(PathFinder(*dry).IsStraightFree(goblin, {-10.0, 0.0}, {10.0, 0.0}));
  PathFinder paths(*snowy);
  EXPECT_FALSE(paths.IsStraightFree(goblin, {-10.0, 0.0}, {10.0, 0.0}));
  const FoundPath path = paths.Find(goblin, {-10.0, 0.0}, {10.0, 0.0});
  EXPECT_FALSE(path.complete);
  ASSERT_FALSE(path.points.empty());
  EXPECT_LT(path.points.back().x_m, 1.0);  // as near as it gets
}

TEST(PathFinderTest, WhoStandsTooCloseToAWallFindsOutOnHisSide) {
  TestScene made;
  made.AddBuilding(0.51, 0.0, 0.03, 20.0);
  made.AddTree(-1.0, 0.0, 0.1);
  const auto scene = made.Build();
  PathFinder paths(*scene);
  const Species& goblin = Of("goblin");
  // Within its own radius of the wall, and the nearest free cell is behind that.
  const WorldPoint from{0.45, 0.0};
  EXPECT_TRUE(paths.IsStraightFree(goblin, from, {-5.0, 10.0}));
  EXPECT_FALSE(paths.IsStraightFree(goblin, from, {10.0, 0.0}));
  const FoundPath path = paths.Find(goblin, from, {10.0, 0.0});
  ASSERT_TRUE(path.complete);
  EXPECT_LT(path.points.front().x_m, 0.5);
  EXPECT_GT(path.length_m, 35.0);
}

TEST(PathFinderTest, AGoalInsideAHouseStandsForThePlaceBeforeIt) {
  TestScene made;
  made.AddBuilding(0.0, 0.0, 4.0, 4.0);
  const auto scene = made.Build();
  PathFinder paths(*scene);
  const FoundPath path = paths.Find(Of("goblin"), {-20.0, 0.0}, {-2.0, 0.0});
  EXPECT_FALSE(path.complete);
  ASSERT_FALSE(path.points.empty());
  EXPECT_NEAR(path.points.back().x_m, -5.0, 1.0);
}

TEST(PathFinderTest, AFallenStemClosesAWayAndAGoneOneOpensIt) {
  TestScene made;
  made.AddBuilding(-9.5, 0.0, 8.0, 1.0);  // two walls with a gap of 3 m, a tree beside it
  made.AddBuilding(9.5, 0.0, 8.0, 1.0);
  made.AddTree(-1.2, 3.0, 0.2);
  const auto scene = made.Build();
  PathFinder paths(*scene);
  const Species& goblin = Of("goblin");
  const WorldPoint from{0.4, -8.0}, to{0.4, 8.0};
  EXPECT_TRUE(paths.IsStraightFree(goblin, from, to));
  SceneChanges changes;
  changes.fallen = {Lying(*scene, 2, -0.3)};
  paths.Update(changes);
  EXPECT_FALSE(paths.IsStraightFree(goblin, from, to));
  const FoundPath around = paths.Find(goblin, from, to);
  ASSERT_TRUE(around.complete);
  EXPECT_TRUE(IsClear(*scene, changes, goblin, from, around));
  paths.Update({{}, {2}});
  EXPECT_TRUE(paths.IsStraightFree(goblin, from, to));
  paths.Update({});
  EXPECT_FALSE(paths.IsStraightFree(goblin, {-1.2, -8.0}, {-1.2, 8.0}));  // it stands again
}

TEST(PathFinderTest, AStemThatHangsHighLetsSmallBodiesThrough) {
  TestScene made;
  made.AddTree(-4.0, 0.0, 0.2);
  const auto scene = made.Build();
  PathFinder paths(*scene);
  SceneChanges changes;
  changes.fallen = {Lying(*scene, 0, 0.0)};
  changes.fallen[0].foot_m.z() += 1.5;
  changes.fallen[0].tip_m.z() += 1.5;
  paths.Update(changes);
  EXPECT_TRUE(paths.IsStraightFree(Of("robotic dog"), {-2.0, -5.0}, {-2.0, 5.0}));
  EXPECT_FALSE(paths.IsStraightFree(Of("ancient warrior"), {-2.0, -5.0}, {-2.0, 5.0}));
}

TEST(PathFinderTest, AfterChangesItAnswersAsOneThatWasMadeWithThem) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const auto scene = Forest(120, seed).Build();
    RandomStream random(seed, "changes");
    PathFinder used(*scene);
    SceneChanges changes;
    for (int round = 0; round < 6; ++round) {
      // Trees fall, roll on, go and come back.
      changes.fallen.clear();
      changes.gone.clear();
      for (std::uint32_t i = 0; i < scene->assets.size(); ++i) {
        if (random.Chance(0.1))
          changes.fallen.push_back(Lying(*scene, i, random.Uniform(-3, 3)));
        else if (random.Chance(0.05))
          changes.gone.push_back(i);
      }
      used.Update(changes);
      PathFinder fresh(*scene);
      fresh.Update(changes);
      for (int i = 0; i < 6; ++i) {
        const Species& species = Of(i % 2 == 0 ? "goblin" : "sheep");
        const WorldPoint from{random.Uniform(-28.0, 28.0), random.Uniform(-28.0, 28.0)};
        const WorldPoint to{random.Uniform(-28.0, 28.0), random.Uniform(-28.0, 28.0)};
        const FoundPath a = used.Find(species, from, to), b = fresh.Find(species, from, to);
        ASSERT_EQ(a.points.size(), b.points.size()) << "seed " << seed << ", round " << round;
        for (std::size_t k = 0; k < a.points.size(); ++k) {
          EXPECT_EQ(a.points[k].x_m, b.points[k].x_m);
          EXPECT_EQ(a.points[k].y_m, b.points[k].y_m);
        }
        EXPECT_EQ(a.complete, b.complete);
      }
    }
  }
}

TEST(PathFinderTest, EndsBeyondTheWorldAndShutInAreNoWay) {
  TestScene made;
  for (const double side : {-3.0, 3.0}) {
    made.AddBuilding(side, 0.0, 0.5, 4.0);
    made.AddBuilding(0.0, side, 4.0, 0.5);
  }
  const auto scene = made.Build();
  PathFinder paths(*scene);
  const FoundPath shut_in = paths.Find(Of("goblin"), {0.0, 0.0}, {20.0, 0.0});
  EXPECT_FALSE(shut_in.complete);
  for (const WorldPoint point : shut_in.points) EXPECT_LT(std::abs(point.x_m), 2.5);
  EXPECT_FALSE(paths.Find(Of("goblin"), {-20.0, 0.0}, {500.0, 0.0}).complete);
  EXPECT_TRUE(paths.Find(Of("goblin"), {500.0, 0.0}, {0.0, 20.0}).points.empty());
  const double nan = std::nan("");
  EXPECT_TRUE(paths.Find(Of("goblin"), {nan, 0.0}, {0.0, 20.0}).points.empty());
  EXPECT_FALSE(paths.Find(Of("goblin"), {0.0, 20.0}, {nan, nan}).complete);
  EXPECT_FALSE(paths.IsStraightFree(Of("goblin"), {0.0, 20.0}, {nan, 0.0}));
}

}  // namespace
}  // namespace latticeworld
