#include "latticeworld/reference_navigator/navigator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/common/random.h"
#include "reference_navigator/kinematic_world.h"

namespace latticeworld {
namespace {

std::unique_ptr<Navigator> Make(const NavigatorOptions& options) {
  auto made = Navigator::Create(options);
  EXPECT_TRUE(made.ok()) << made.status().ToString();
  return *std::move(made);
}

// Of a robot that the gaps of these worlds were made for.
NavigatorOptions OfSmallRobot() {
  NavigatorOptions options;
  options.robot.radius_m = 0.3;
  return options;
}

// A world of 64 m with `mapped` and `unmapped` discs at random, none near its two far corners.
KinematicWorld RandomWorld(std::uint64_t seed, const NavigatorRobot& robot, int mapped,
                           int unmapped) {
  KinematicWorld world(64.0, robot);
  RandomStream random(seed, "discs");
  const auto scatter = [&](int count, double least_m, double most_m, std::vector<Disc>* discs) {
    for (int i = 0; i < count; ++i) {
      const Disc disc{random.Uniform(-28, 28), random.Uniform(-28, 28),
                      random.Uniform(least_m, most_m)};
      const double far_m = std::min(std::hypot(disc.x_m + 29, disc.y_m + 29),
                                    std::hypot(disc.x_m - 29, disc.y_m - 29));
      if (far_m > disc.radius_m + 1.5) discs->push_back(disc);
    }
  };
  scatter(mapped, 0.3, 1.5, &world.mapped);
  scatter(unmapped, 0.15, 0.8, &world.unmapped);
  world.Place(-29, -29, 0.7);
  return world;
}

class DrivesTest : public testing::TestWithParam<double> {};  // radius that it turns in at least

TEST_P(DrivesTest, RoundWhatTheMapHasAndWhatItHasNotWithoutTouching) {
  NavigatorOptions options = OfSmallRobot();
  options.robot.min_turn_radius_m = GetParam();
  if (GetParam() > 0.0) options.robot.max_reverse_mps = 0.5;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    KinematicWorld world = RandomWorld(seed, options.robot, 40, 25);
    const auto navigator = Make(options);
    navigator->SetMap(world.Map());
    ASSERT_TRUE(navigator->SetGoal({29, 29}, std::nullopt, world.Pose()).ok());
    const NavigatorOutput end = DriveToTheEnd(navigator.get(), &world, 300.0);
    EXPECT_EQ(end.state, NavigatorState::kArrived) << seed << ": " << end.why.ToString();
    EXPECT_LE(std::hypot(world.x_m() - 29, world.y_m() - 29), options.goal_radius_m);
    EXPECT_GT(world.least_room_m(), 0.0) << seed;
    EXPECT_LE(world.most_speed_mps(), options.robot.max_speed_mps + 1e-9);
    EXPECT_LT(world.length_m(), 1.35 * std::hypot(58, 58)) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, DrivesTest, testing::Values(0.0, 1.0));

class NavigatorTest : public testing::Test {
 protected:
  NavigatorTest() : world_(32.0, options_.robot) {}
  // A wall of discs from one place to another.
  static std::vector<Disc> Wall(double x0, double y0, double x1, double y1) {
    std::vector<Disc> discs;
    const double length_m = std::hypot(x1 - x0, y1 - y0);
    const int count = static_cast<int>(length_m / 0.2) + 1;
    for (int i = 0; i <= count; ++i) {
      const double share = static_cast<double>(i) / count;
      discs.push_back({x0 + share * (x1 - x0), y0 + share * (y1 - y0), 0.15});
    }
    return discs;
  }
  static void Append(std::vector<Disc>* discs, const std::vector<Disc>& more) {
    discs->insert(discs->end(), more.begin(), more.end());
  }
  std::unique_ptr<Navigator> Begin(WorldPoint goal,
                                   std::optional<double> heading_rad = std::nullopt) {
    auto navigator = Make(options_);
    navigator->SetMap(world_.Map());
    const Status begun = navigator->SetGoal(goal, heading_rad, world_.Pose());
    EXPECT_TRUE(begun.ok()) << begun.ToString();
    return navigator;
  }

  NavigatorOptions options_ = OfSmallRobot();
  KinematicWorld world_;
};

TEST_F(NavigatorTest, TakesAnotherWayWhereAPassageTurnsOutToBeClosed) {
  // Two gaps in a wall; the near one is closed by what the map has not.
  Append(&world_.mapped, Wall(0, -15.5, 0, -2));
  Append(&world_.mapped, Wall(0, 2, 0, 9));
  Append(&world_.mapped, Wall(0, 13, 0, 15.5));
  Append(&world_.unmapped, Wall(0, -2, 0, 2));
  world_.Place(-8, 0, 0);
  const auto navigator = Begin({8, 0});
  const NavigatorOutput end = DriveToTheEnd(navigator.get(), &world_, 200.0);
  EXPECT_EQ(end.state, NavigatorState::kArrived) << end.why.ToString();
  EXPECT_GT(world_.least_room_m(), 0.0);
}

TEST_F(NavigatorTest, SaysThatEveryWayIsClosedByWhatItSees) {
  options_.patience_s = 2.0;
  options_.recoveries = 2;
  for (const auto& wall :
       {Wall(5, -3, 11, -3), Wall(11, -3, 11, 3), Wall(11, 3, 5, 3), Wall(5, 3, 5, -3)})
    Append(&world_.unmapped, wall);
  world_.Place(-8, 0, 0);
  const auto navigator = Begin({8, 0});
  const NavigatorOutput end = DriveToTheEnd(navigator.get(), &world_, 400.0);
  EXPECT_EQ(end.state, NavigatorState::kFailed);
  EXPECT_FALSE(end.why.ok());
  EXPECT_GT(world_.least_room_m(), 0.0);
}

TEST_F(NavigatorTest, LetsPassWhatCrossesItsWay) {
  world_.moving = [](double time_s) {
    return std::vector<Disc>{{0.0, -9.0 + 0.8 * time_s, 0.4}, {4.0, 12.0 - 0.6 * time_s, 0.4}};
  };
  world_.Place(-8, 0, 0);
  const auto navigator = Begin({8, 0});
  const NavigatorOutput end = DriveToTheEnd(navigator.get(), &world_, 120.0);
  EXPECT_EQ(end.state, NavigatorState::kArrived) << end.why.ToString();
  EXPECT_GT(world_.least_room_m(), 0.0);
}

TEST_F(NavigatorTest, StandsAsTheGoalPoints) {
  options_.goal_heading_tolerance_rad = 0.2;
  world_.Place(-8, 0, 0);
  const auto navigator = Begin({4, 4}, -2.0);
  const NavigatorOutput end = DriveToTheEnd(navigator.get(), &world_, 100.0);
  EXPECT_EQ(end.state, NavigatorState::kArrived) << end.why.ToString();
  const Eigen::Matrix3d turned = world_.Pose().map_from_base.linear();
  EXPECT_NEAR(std::remainder(std::atan2(turned(1, 0), turned(0, 0)) + 2.0, 2 * M_PI), 0.0, 0.2);
}

TEST_F(NavigatorTest, GivesTheSameCommandsForTheSameCalls) {
  const auto run = [&] {
    KinematicWorld world = RandomWorld(3, options_.robot, 30, 20);
    const auto navigator = Make(options_);
    navigator->SetMap(world.Map());
    EXPECT_TRUE(navigator->SetGoal({29, 29}, std::nullopt, world.Pose()).ok());
    (void)DriveToTheEnd(navigator.get(), &world, 20.0);
    return std::make_pair(world.x_m(), world.y_m());
  };
  EXPECT_EQ(run(), run());
}

TEST_F(NavigatorTest, GroundThatRisesIntoALevelScanIsNoObstacle) {
  // A ramp of the map's cost 30 (of 50 at the steepest) ahead; the scan meets it 3 m away, and a
  // post stands on the flat beside.
  const auto navigator = Make(options_);
  CostMap map = world_.Map();
  for (int row = 1; row < map.cost.rows() - 1; ++row)
    for (int col = map.cost.cols() / 2 + 4; col < map.cost.cols() - 1; ++col)
      map.cost(row, col) = 30;
  navigator->SetMap(map);
  world_.Place(0, 0, 0);
  ASSERT_TRUE(navigator->SetGoal({12, 0}, std::nullopt, world_.Pose()).ok());
  (void)navigator->Update(world_.Pose());
  SensorSighting scan;
  scan.planar = true;
  scan.map_from_sensor = world_.Pose().map_from_base;
  scan.map_from_sensor.translation().z() = 0.3;
  for (double y_m = -6.0; y_m <= 6.0; y_m += 0.05)
    scan.hits_m.emplace_back(3.2f, static_cast<float>(y_m), 0.0f);
  navigator->See(scan);
  NavigatorPose pose = world_.Pose();
  pose.time_s = 0.1;
  NavigatorOutput output = navigator->Update(pose);
  EXPECT_EQ(output.state, NavigatorState::kFollowing);
  EXPECT_GT(output.speed_mps, 0.0);
  EXPECT_LT(output.way_left_m, 12.5) << "straight over the ramp";
}

TEST_F(NavigatorTest, RefusesBadGoalsAndGoesOnWithTheGoalBefore) {
  world_.mapped = {{5, 5, 2}};
  for (const auto& wall :
       {Wall(-6, 6, -2, 6), Wall(-2, 6, -2, 10), Wall(-2, 10, -6, 10), Wall(-6, 10, -6, 6)})
    Append(&world_.mapped, wall);
  const auto without_map = Make(options_);
  EXPECT_EQ(without_map->SetGoal({1, 1}, std::nullopt, world_.Pose()).code(),
            StatusCode::kFailedPrecondition);
  const auto navigator = Begin({-8, -8});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](WorldPoint goal) {
    return navigator->SetGoal(goal, std::nullopt, world_.Pose());
  };
  EXPECT_EQ(refused({nan, 0}).code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(navigator->SetGoal({1, 1}, nan, world_.Pose()).code(), StatusCode::kInvalidArgument);
  const Status outside = refused({40, 0});
  EXPECT_EQ(outside.code(), StatusCode::kOutOfRange);
  EXPECT_NE(outside.message().find("16"), std::string::npos) << outside.message();
  const Status closed = refused({5, 5});
  EXPECT_EQ(closed.code(), StatusCode::kFailedPrecondition);
  EXPECT_NE(closed.message().find("nearest free"), std::string::npos) << closed.message();
  EXPECT_EQ(refused({-4, 8}).code(), StatusCode::kNotFound);
  EXPECT_EQ(DriveToTheEnd(navigator.get(), &world_, 60.0).state, NavigatorState::kArrived);
  EXPECT_NEAR(world_.x_m(), -8, options_.goal_radius_m);
}

TEST_F(NavigatorTest, StopsWhenItIsCancelledAndStaysWithAnUnusablePose) {
  world_.Place(-8, 0, 0);
  const auto navigator = Begin({8, 0});
  (void)DriveToTheEnd(navigator.get(), &world_, 3.0);
  NavigatorPose broken = world_.Pose();
  broken.map_from_base.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(navigator->Update(broken).speed_mps, 0.0);
  EXPECT_EQ(navigator->Update(world_.Pose()).state, NavigatorState::kFollowing);
  navigator->Cancel();
  const NavigatorOutput output = navigator->Update(world_.Pose());
  EXPECT_EQ(output.state, NavigatorState::kIdle);
  EXPECT_EQ(output.speed_mps, 0.0);
}

TEST_F(NavigatorTest, EndsAtItsTimeLimit) {
  options_.time_limit_s = 2.0;
  world_.Place(-8, 0, 0);
  const auto navigator = Begin({8, 0});
  const NavigatorOutput end = DriveToTheEnd(navigator.get(), &world_, 60.0);
  EXPECT_EQ(end.state, NavigatorState::kFailed);
  EXPECT_EQ(end.why.code(), StatusCode::kDeadlineExceeded);
}

TEST_F(NavigatorTest, PlansToTheNearestFreePlaceWithinATolerance) {
  world_.mapped = {{5, 5, 2}};
  const auto navigator = Begin({-8, -8});
  EXPECT_EQ(navigator->Plan({0, 0}, {5, 5}, 0.5).status().code(), StatusCode::kFailedPrecondition);
  const auto way = navigator->Plan({0, 0}, {5, 5}, 4.0);
  ASSERT_TRUE(way.ok()) << way.status().ToString();
  EXPECT_NEAR(way->front().x_m, 0.0, 1e-9);
  EXPECT_LE(std::hypot(way->back().x_m - 5, way->back().y_m - 5), 4.0);
}

TEST(NavigatorOptionsTest, NamesEveryOptionThatIsNotLegal) {
  NavigatorOptions options;
  options.robot.radius_m = -1.0;
  options.goal_radius_m = 0.0;
  options.closed_cost = 0;
  options.patience_s = std::numeric_limits<double>::quiet_NaN();
  const auto made = Navigator::Create(options);
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.status().code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(made.status().violations().size(), 4u) << made.status().ToString();
}

}  // namespace
}  // namespace latticeworld
