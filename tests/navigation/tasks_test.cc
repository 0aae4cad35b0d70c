#include "latticeworld/navigation/tasks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/navigation/distance_field.h"
#include "latticeworld/navigation/navigable_map.h"
#include "latticeworld/scene/agents/spawn_rules.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

// Hills with a pond, trees and a few sheep, another for each seed.
std::shared_ptr<const Scene> Land(std::uint64_t seed) {
  TestScene land;
  RandomStream random(seed, "land");
  land.height_m = Hills(random.Uniform(0.5, 2.0), 30.0);
  const double x_m = random.Uniform(-15.0, 15.0), y_m = random.Uniform(-15.0, 15.0);
  land.water_depth_m = [=](double x, double y) {
    return std::hypot(x - x_m, y - y_m) < 7.0 ? 1.0 : 0.0;
  };
  for (int i = 0; i < 30; ++i)
    land.AddTree(random.Uniform(-30.0, 30.0), random.Uniform(-30.0, 30.0));
  for (int i = 0; i < 5; ++i)
    land.AddAgent("sheep_" + std::to_string(i), AgentCategory::kSheep, 6.0 * i - 12.0, 20.0);
  return land.Build();
}

TaskWishes Wishes(std::uint64_t seed, int count = 5) {
  TaskWishes wishes;
  wishes.seed = seed;
  wishes.count = count;
  return wishes;
}

TEST(Tasks, AreSolvableForTheRobotAndOfTheWantedDifficulty) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const std::shared_ptr<const Scene> scene = Land(seed);
    TaskWishes wishes = Wishes(seed);
    wishes.length_m = {25.0, 45.0};
    wishes.detour = {1.0, 1.5};
    const NavigableMap map = BuildNavigableMap(*scene, wishes.robot);
    const auto tasks = SampleTasks(*scene, wishes, Progress()).value();
    ASSERT_EQ(tasks.size(), 5u);
    for (const NavigationTask& task : tasks) {
      EXPECT_TRUE(map.IsFree(task.start));
      EXPECT_TRUE(map.IsFree(task.goal));
      for (std::size_t i = 1; i < task.way.points_m.size(); ++i) {
        const Eigen::Vector3d &a = task.way.points_m[i - 1], &b = task.way.points_m[i];
        EXPECT_TRUE(MeasureLine(map, {a.x(), a.y()}, {b.x(), b.y()}).is_free);
      }
      const double length_m = DistancesTo(map, task.goal).value().At(task.start);
      EXPECT_NEAR(task.difficulty.length_m, length_m, 0.03 * length_m + 0.5);
      EXPECT_GE(task.difficulty.length_m, 25.0);
      EXPECT_LE(task.difficulty.length_m, 45.0);
      EXPECT_GE(task.difficulty.detour, 1.0);
      EXPECT_LE(task.difficulty.detour, 1.5);
    }
  }
}

// Planners such as navfn and global_planner take the outermost cells for closed.
TEST(Tasks, KeepTheRobotsDiscInTheWorldLessItsOutermostCells) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    TestScene land;
    land.cells = seed % 2 == 0 ? 32 : 128;
    const std::shared_ptr<const Scene> scene = land.Build();
    TaskWishes wishes = Wishes(seed, 100);
    wishes.robot.radius_m = 0.2 * static_cast<double>(seed);
    const GridGeometry& geometry = scene->geometry();
    const double limit_m =
        geometry.half_size_m() - geometry.resolution_m() - wishes.robot.radius_m + 1e-9;
    for (const NavigationTask& task : SampleTasks(*scene, wishes, Progress()).value()) {
      for (const WorldPoint end : {task.start, task.goal})
        EXPECT_LE(std::max(std::abs(end.x_m), std::abs(end.y_m)), limit_m) << seed;
      for (const Eigen::Vector3d& corner : task.way.points_m)
        EXPECT_LE(corner.head<2>().cwiseAbs().maxCoeff(), limit_m) << seed;
    }
  }
}

TEST(Tasks, BeginWhereTheRobotIsPut) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const std::shared_ptr<const Scene> scene = Land(seed);
    for (const double radius_m : {RobotLimits().radius_m, 1.0}) {
      TaskWishes wishes = Wishes(seed, 40);
      wishes.robot.radius_m = radius_m;
      for (const NavigationTask& task : SampleTasks(*scene, wishes, Progress()).value()) {
        const Status put = CheckSpawn(*scene, scene->atmosphere, AgentCategory::kWheeledRobot,
                                      radius_m, task.start);
        EXPECT_TRUE(put.ok()) << put.ToString();
      }
    }
  }
}

TEST(Tasks, AreForTheFootprintOfTheBuiltInRobotUnlessSaidOtherwise) {
  EXPECT_EQ(TaskWishes().robot.radius_m, BodyRadius(AgentCategory::kWheeledRobot));
}

TEST(Tasks, AreTheSameForTheSameSeedAndOthersForAnother) {
  const std::shared_ptr<const Scene> scene = Land(3);
  const auto first = SampleTasks(*scene, Wishes(7), Progress()).value();
  const auto again = SampleTasks(*scene, Wishes(7), Progress()).value();
  const auto other = SampleTasks(*scene, Wishes(8), Progress()).value();
  bool differs = false;
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].start.x_m, again[i].start.x_m);
    EXPECT_EQ(first[i].goal.y_m, again[i].goal.y_m);
    EXPECT_EQ(first[i].way.length_m, again[i].way.length_m);
    differs = differs || first[i].goal.x_m != other[i].goal.x_m;
  }
  EXPECT_TRUE(differs);
}

TEST(Tasks, CountTheAgentsBesideTheWay) {
  const std::shared_ptr<const Scene> scene = Land(4);
  TaskWishes wishes = Wishes(1, 3);
  wishes.agents = {4.0, 5.0};
  const auto tasks = SampleTasks(*scene, wishes, Progress());
  for (const NavigationTask& task : tasks.value()) EXPECT_GE(task.difficulty.agents, 4);
}

TEST(Tasks, ClimbOnASlopeIsItsRise) {
  TestScene slope;
  slope.height_m = [](double x, double) { return 0.2 * x; };
  TaskWishes wishes = Wishes(1, 20);
  const auto tasks = SampleTasks(*slope.Build(), wishes, Progress());
  for (const NavigationTask& task : tasks.value()) {
    const double rise_m = 0.2 * (task.goal.x_m - task.start.x_m);
    EXPECT_NEAR(task.difficulty.climb_m, std::max(0.0, rise_m), 0.02);
    EXPECT_NEAR(task.difficulty.detour, 1.0, 0.01);
    EXPECT_EQ(task.difficulty.density, 0.0);
  }
}

TEST(Tasks, SayWhatTheWorldOffersWhereItHasNotWhatIsWanted) {
  const std::shared_ptr<const Scene> scene = Land(5);
  TaskWishes wishes = Wishes(1, 1);
  wishes.climb_m = {500.0, 600.0};
  const Status status = SampleTasks(*scene, wishes, Progress()).status();
  EXPECT_EQ(status.code(), StatusCode::kFailedPrecondition);
  EXPECT_NE(status.message().find("; climb_m was outside [500, 600] in 1000 of 1000 ways"),
            std::string::npos)
      << status.message();
  wishes = Wishes(1, 1);
  wishes.length_m = {5000.0, 6000.0};
  EXPECT_NE(SampleTasks(*scene, wishes, Progress()).status().message().find("no way of a wanted"),
            std::string::npos);
}

TEST(Tasks, RefuseWishesThatAreNone) {
  TaskWishes wishes = Wishes(1, 0);
  wishes.goal_radius_m = -1.0;
  wishes.detour = {3.0, 2.0};
  wishes.climb_m = {std::nan(""), 1.0};
  const Status status = Validate(wishes);
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(status.violations().size(), 4u);
}

TEST(Tasks, BeginAndEndOutsideOfBushes) {
  TestScene land;
  Asset bush;
  bush.kind = AssetKind::kBush;
  bush.model = Catalogue::BuiltIn()->models_of(bush.kind).front();
  bush.height_m = 2.0f;
  bush.half_length_m = bush.half_width_m = 4.0f;
  for (int i = 0; i < 9; ++i) {
    bush.x_m = static_cast<float>(-20 + 20 * (i % 3));
    bush.y_m = static_cast<float>(-20 + 20 * (i / 3));
    land.assets.push_back(bush);
  }
  const auto scene = land.Build();
  TaskWishes wishes;
  wishes.count = 40;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    wishes.seed = seed;
    const auto tasks = SampleTasks(*scene, wishes, Progress()).value();
    for (const NavigationTask& task : tasks) {
      for (const Asset& asset : scene->assets) {
        for (const WorldPoint end : {task.start, task.goal})
          EXPECT_GE(std::hypot(end.x_m - asset.x_m, end.y_m - asset.y_m),
                    4.0 + wishes.robot.radius_m);
      }
    }
  }
}

}  // namespace
}  // namespace latticeworld
