#include "latticeworld/simulation/sensed.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "latticeworld/sensing/motion/wheel_odometry.h"
#include "latticeworld/sensing/sensor_suite.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

SensedWorld Sense(const Simulator& simulator) {
  return Sensed(*simulator.State(), *simulator.options().species);
}
const SensedAgent& Find(const SensedWorld& world, const std::string& name) {
  for (const SensedAgent& agent : world.agents) {
    if (agent.name == name) return agent;
  }
  throw std::out_of_range(name);
}

TEST(SensedTest, ItIsTheStateOfTheEpisode) {
  TestScene scene;
  scene.AddAgent("sheep", AgentCategory::kSheep, 5.0, 3.0);
  scene.AddProp("box", PropKind::kCrate, -4.0, 2.0);
  const auto simulator = MakeSimulator(scene);
  RunFor(simulator.get(), 0.2);
  simulator->Reset(simulator->seed());
  RunFor(simulator.get(), 0.1);
  const SensedWorld world = Sense(*simulator);
  EXPECT_EQ(world.step, 10u);
  EXPECT_NEAR(world.time_s, 0.1, 1e-9);
  ASSERT_EQ(world.props.size(), 1u);
  EXPECT_EQ(world.props[0].name, "box");
  EXPECT_NEAR(world.props[0].map_from_prop.translation().x(), -4.0, 0.01);
  const SensedAgent& sheep = Find(world, "sheep");
  EXPECT_EQ(sheep.category, AgentCategory::kSheep);
  EXPECT_FALSE(sheep.has_sensors);
  EXPECT_EQ(sheep.height_m, simulator->options().species->Find("sheep")->height_m);
  EXPECT_FALSE(sheep.wheels.has_value());
}

TEST(SensedTest, VelocitiesAreInTheMapAndTurnsInTheBody) {
  TestScene scene;
  const auto simulator = MakeSimulator(scene);
  SpawnRequest request = RequestFor("wheeled robot", "robot", 0.0, 0.0);
  request.heading_rad = M_PI / 2.0;
  request.controllable = true;
  MustSpawn(simulator.get(), request);
  RunWith(simulator.get(), 2.0, "robot", Forward(1.0));
  const SensedAgent robot = Find(Sense(*simulator), "robot");
  EXPECT_TRUE(robot.has_sensors);
  EXPECT_NEAR(robot.linear_velocity_mps.y(), 1.0, 0.1);
  EXPECT_NEAR(robot.linear_velocity_mps.x(), 0.0, 0.1);
  EXPECT_NEAR(robot.map_from_base.linear()(1, 0), 1.0, 0.02);
}

TEST(SensedTest, EncodersTellTheWay) {
  TestScene scene;
  for (const char* species : {"wheeled robot", "ackermann car"}) {
    const auto simulator = MakeSimulator(scene);
    SpawnRequest request = RequestFor(species, "robot", -20.0, 0.0);
    request.controllable = true;
    MustSpawn(simulator.get(), request);
    RunWith(simulator.get(), 3.0, "robot", Forward(1.0));
    const SensedAgent before = Find(Sense(*simulator), "robot");
    simulator->Step();
    const SensedAgent after = Find(Sense(*simulator), "robot");
    ASSERT_TRUE(after.wheels.has_value()) << species;
    const double way_m =
        (after.map_from_base.translation() - before.map_from_base.translation()).head<2>().norm();
    const double rolled_m =
        std::remainder(after.wheels->left_rad - before.wheels->left_rad, 2.0 * M_PI) *
        after.wheels->wheel_radius_m;
    EXPECT_NEAR(rolled_m, way_m, 0.1 * way_m) << species;
    EXPECT_NEAR(after.wheels->right_radps * after.wheels->wheel_radius_m, 1.0, 0.1) << species;
    EXPECT_EQ(after.wheels->steering_rad.has_value(), std::string(species) == "ackermann car");
  }
}

TEST(SensedTest, AnAckermannCarsMiddleWheelFollowsItsCurve) {
  TestScene scene;
  const auto simulator = MakeSimulator(scene);
  SpawnRequest request = RequestFor("ackermann car", "car", 0.0, 0.0);
  request.controllable = true;
  MustSpawn(simulator.get(), request);
  RunWith(simulator.get(), 4.0, "car", Forward(2.0, 0.4));
  const SensedAgent car = Find(Sense(*simulator), "car");
  ASSERT_TRUE(car.wheels && car.wheels->steering_rad);
  EXPECT_NEAR(std::tan(*car.wheels->steering_rad) / car.wheels->wheelbase_m, 0.4 / 2.0, 0.02);
}

// A drive of five seconds.
struct Drive {
  double speed_mps, yaw_rate_radps;
  SurfaceClass surface;
  double slope = 0.0;  // of the ground to the north-east
};

// How far a robot's reckoning was off, over what it says itself: of yaw rates the mean of squares,
// of the pose at the end the squared error (three degrees of freedom).
struct Reckoning {
  double rate = 0.0, pose = 0.0;
};

// The encoders of the built-in suites.
WheelOdometryModel ShippedOdometry() {
  for (const SensorSpec& sensor : SensorCatalogue::BuiltIn()->FindSuite("scanner")->sensors) {
    if (sensor.name == "wheel_odom") return std::get<WheelOdometryModel>(sensor.model);
  }
  throw std::out_of_range("wheel_odom");
}

double YawIn(const Eigen::Isometry3d& pose) {
  return std::atan2(pose.linear()(1, 0), pose.linear()(0, 0));
}

// A robot's place and yaw in a level frame where it began, less what was reckoned.
Eigen::Vector3d ErrorOf(const WheelOdometryReading& reading,
                        const Eigen::Isometry3d& map_from_begin,
                        const Eigen::Isometry3d& map_from_base) {
  const Eigen::Vector2d moved_m =
      Eigen::Rotation2Dd(-YawIn(map_from_begin)) *
      (map_from_base.translation() - map_from_begin.translation()).head<2>();
  const double turned_rad = YawIn(map_from_base) - YawIn(map_from_begin);
  return {reading.position_m.x() - moved_m.x(), reading.position_m.y() - moved_m.y(),
          std::remainder(reading.heading_rad - turned_rad, 2.0 * M_PI)};
}

Reckoning Reckon(const std::string& species, const Drive& drive, std::uint64_t key) {
  TestScene scene;
  scene.surface = [&drive](double, double) { return drive.surface; };
  scene.height_m = [&drive](double x_m, double y_m) {
    return drive.slope * M_SQRT1_2 * (x_m + y_m);
  };
  const auto simulator = MakeSimulator(scene);
  SpawnRequest request = RequestFor(species, "robot", 0.0, 0.0);
  request.controllable = true;
  MustSpawn(simulator.get(), request);
  RunFor(simulator.get(), 1.0);
  WheelOdometer odometer(ShippedOdometry(), key);
  SensedAgent robot = Find(Sense(*simulator), "robot");
  const Eigen::Isometry3d map_from_begin = robot.map_from_base;
  odometer.Begin(*robot.wheels);
  Reckoning reckoning;
  WheelOdometryReading reading;
  constexpr int kReadings = 250;
  for (int i = 1; i <= 2 * kReadings; ++i) {
    RunWith(simulator.get(), 0.01, "robot", Forward(drive.speed_mps, drive.yaw_rate_radps));
    robot = Find(Sense(*simulator), "robot");
    odometer.Add(*robot.wheels, 0.01);
    if (i % 2 != 0) continue;
    reading = odometer.Read(i / 2);
    const double off_radps = reading.yaw_rate_radps - robot.angular_velocity_radps.z();
    reckoning.rate += off_radps * off_radps / reading.twist_variances.z() / kReadings;
  }
  const Eigen::Vector3d off = ErrorOf(reading, map_from_begin, robot.map_from_base);
  reckoning.pose = off.dot(reading.pose_covariance.inverse() * off);
  return reckoning;
}

// Three speeds, both turns, three grounds, and slopes that it goes up, down and along.
std::vector<Drive> Drives() {
  std::vector<Drive> drives;
  for (const double yaw_rate_radps : {0.4, -0.4}) {
    for (const SurfaceClass surface :
         {SurfaceClass::kRoad, SurfaceClass::kGrass, SurfaceClass::kFarmland}) {
      for (const double speed_mps : {0.4, 1.0, 1.5}) {
        drives.push_back({speed_mps, yaw_rate_radps, surface});
      }
    }
    for (const double slope : {0.2, -0.2}) {
      drives.push_back({1.0, yaw_rate_radps, SurfaceClass::kGrass, slope});
    }
  }
  return drives;
}

// Beyond which 1 of 1000 means of so many squared errors of three degrees of freedom lies (Wilson
// and Hilferty 1931).
double BoundOfMean(std::size_t errors) {
  const double degrees = 3.0 * static_cast<double>(errors);
  const double part = 2.0 / (9.0 * degrees);
  return 3.0 * std::pow(1.0 - part + 3.09 * std::sqrt(part), 3);
}

// Wheels that skid hold a turn back by 0.01 (road) to 0.07 rad a metre (farmland): their rates were
// off by several times what was stated.
TEST(SensedTest, WheelOdometryErrsAsMuchAsItSaysOnGroundsOfAllKinds) {
  const std::vector<Drive> drives = Drives();
  for (const char* species : {"wheeled robot", "skid steer robot"}) {
    Reckoning mean;
    for (std::size_t i = 0; i < drives.size(); ++i) {
      const Reckoning reckoning = Reckon(species, drives[i], i + 1);
      mean.rate += reckoning.rate / drives.size();
      mean.pose += reckoning.pose / drives.size();
      EXPECT_LT(reckoning.pose, 16.3) << species << ", drive " << i;  // 99.9 % of one
    }
    EXPECT_LT(mean.pose, BoundOfMean(drives.size())) << species;
    EXPECT_LT(mean.rate, 2.0) << species;
    EXPECT_GT(mean.rate, 0.1) << species;
  }
}

TEST(SensedTest, ARobotFeelsTheHouseThatItPushesAgainst) {
  TestScene scene;
  scene.AddBuilding(6.0, 0.0, 2.0, 4.0);
  const auto simulator = MakeSimulator(scene);
  SpawnRequest request = RequestFor("wheeled robot", "robot", 2.0, 0.0);
  request.controllable = true;
  MustSpawn(simulator.get(), request);
  EXPECT_EQ(Find(Sense(*simulator), "robot").contact_force_n, 0.0);
  double hardest_n = 0.0;
  for (int i = 0; i < 400; ++i) {
    RunWith(simulator.get(), 0.01, "robot", Forward(1.0));
    const SensedAgent robot = Find(Sense(*simulator), "robot");
    if (robot.contact_force_n == 0.0) {
      EXPECT_TRUE(robot.contact_direction.isZero());
      continue;
    }
    hardest_n = std::max(hardest_n, robot.contact_force_n);
    EXPECT_GT(robot.contact_direction.x(), 0.5);
    EXPECT_NEAR(robot.contact_direction.norm(), 1.0, 1e-9);
  }
  EXPECT_GT(hardest_n, 5.0);
}

TEST(SensedTest, AFallingTreeIsWhereItFalls) {
  WorldState state;
  state.felled.push_back({{3, {0.0, 0.0, 0.0}, {1.0, 2.0, 3.0}}, false});
  const SensedWorld world = Sensed(state, *SpeciesCatalogue::BuiltIn());
  ASSERT_EQ(world.felled.size(), 1u);
  EXPECT_EQ(world.felled[0].asset, 3u);
  EXPECT_EQ(world.felled[0].tip_m, Eigen::Vector3d(1.0, 2.0, 3.0));
}

}  // namespace
}  // namespace latticeworld
