#include "latticeworld/sensing/motion/wheel_odometry.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "latticeworld/sensing/counter_noise.h"
#include "latticeworld/sensing/motion/bumper.h"

namespace latticeworld {
namespace {

constexpr double kStep_s = 0.005;

// A robot of 0.1 m wheels, 0.5 m apart, whose wheels turn evenly; angles within +-pi as hinges
// tell.
SensedWheels WheelsAt(double time_s, double left_radps, double right_radps) {
  SensedWheels wheels;
  wheels.left_rad = std::remainder(left_radps * time_s, 2.0 * M_PI);
  wheels.right_rad = std::remainder(right_radps * time_s, 2.0 * M_PI);
  wheels.left_radps = left_radps;
  wheels.right_radps = right_radps;
  return wheels;
}

// Reads every 20 ms on the way.
WheelOdometryReading Drive(WheelOdometer* odometer, int steps, double left_radps,
                           double right_radps) {
  odometer->Begin(WheelsAt(0.0, left_radps, right_radps));
  WheelOdometryReading reading;
  for (int i = 1; i <= steps; ++i) {
    odometer->Add(WheelsAt(i * kStep_s, left_radps, right_radps), kStep_s);
    if (i % 4 == 0) reading = odometer->Read(i / 4);
  }
  return reading;
}

TEST(WheelOdometryTest, AnEvenCircleClosesAndIsAsWideAsTheWheelsSay) {
  // 0.8 and 1.2 m/s: 1 m/s, 0.8 rad/s, radius 1.25 m.
  const double turn_s = 2.0 * M_PI / 0.8;
  WheelOdometer odometer({}, 1);
  const int half = static_cast<int>(std::lround(0.5 * turn_s / kStep_s / 4.0)) * 4;
  const WheelOdometryReading across = Drive(&odometer, half, 8.0, 12.0);
  const double turned = 0.8 * half * kStep_s;
  EXPECT_NEAR(across.position_m.x(), 1.25 * std::sin(turned), 1e-9);
  EXPECT_NEAR(across.position_m.y(), 1.25 * (1.0 - std::cos(turned)), 1e-9);
  EXPECT_NEAR(across.forward_mps, 1.0, 1e-9);
  EXPECT_NEAR(across.yaw_rate_radps, 0.8, 1e-9);
  WheelOdometer again({}, 1);
  const WheelOdometryReading whole = Drive(&again, 2 * half, 8.0, 12.0);
  EXPECT_LT(whole.position_m.norm(), 0.02);
  EXPECT_NEAR(std::remainder(whole.heading_rad - 2.0 * turned, 2.0 * M_PI), 0.0, 1e-9);
}

TEST(WheelOdometryTest, FastWheelsAreToldFromSlowOnesThatTurnTheOtherWay) {
  // 250 revolutions a second: more than half a turn between two steps.
  WheelOdometer odometer({}, 1);
  const double fast = 2.0 * M_PI * 250.0 / 2.0;
  EXPECT_NEAR(Drive(&odometer, 200, fast, fast).position_m.x(), 0.1 * fast, 1e-6);
}

TEST(WheelOdometryTest, ASteeredVehicleTurnsAsABicycle) {
  SensedWheels wheels;
  wheels.steering_rad = 0.3;
  wheels.wheelbase_m = 2.0;
  WheelOdometer odometer({}, 1);
  odometer.Begin(wheels);
  wheels.left_radps = wheels.right_radps = 10.0;
  wheels.left_rad = wheels.right_rad = 10.0 * kStep_s;
  odometer.Add(wheels, kStep_s);
  EXPECT_NEAR(odometer.Read(0).yaw_rate_radps, 1.0 * std::tan(0.3) / 2.0, 1e-9);
}

TEST(WheelOdometryTest, SpinningWheelsCountThoughTheRobotStands) {
  WheelOdometer odometer({}, 1);
  EXPECT_NEAR(Drive(&odometer, 200, 5.0, 5.0).position_m.x(), 0.5, 1e-9);
}

TEST(WheelOdometryTest, EncodersCountWholeTicks) {
  WheelOdometryModel model;
  model.ticks_per_revolution = 100.0;
  WheelOdometer odometer(model, 1);
  const double tick_m = 0.1 * 2.0 * M_PI / 100.0;
  const double way_m = Drive(&odometer, 200, 3.01, 3.01).position_m.x();
  EXPECT_NEAR(way_m / tick_m, std::floor(0.301 / tick_m), 1e-6);
  // Rolling to and fro over one tick leads nowhere.
  WheelOdometer still(model, 1);
  still.Begin(WheelsAt(0.0, 0.0, 0.0));
  for (int i = 0; i < 100; ++i) {
    SensedWheels wheels;
    wheels.left_rad = wheels.right_rad = i % 2 == 0 ? 0.01 : -0.01;
    still.Add(wheels, kStep_s);
  }
  EXPECT_LE(still.Read(0).position_m.norm(), tick_m + 1e-12);
}

TEST(WheelOdometryTest, NoiseGrowsAsThrunsModelSays) {
  WheelOdometryModel model;
  model.a1 = 0.01;
  model.a2 = 0.002;
  model.a3 = 0.003;
  model.a4 = 0.004;
  double ways = 0.0, turns = 0.0;
  constexpr int kRobots = 4000;
  for (int i = 0; i < kRobots; ++i) {
    WheelOdometer odometer(model, i);
    const WheelOdometryReading reading = Drive(&odometer, 4, 8.0, 12.0);  // one reading
    ways += std::pow(reading.forward_mps * 0.02 - 0.02, 2);
    turns += std::pow(reading.yaw_rate_radps * 0.02 - 0.016, 2);
  }
  const double way2 = 0.02 * 0.02, turn2 = 0.016 * 0.016;
  EXPECT_NEAR(std::sqrt(turns / kRobots), std::sqrt(0.01 * turn2 + 0.002 * way2), 1e-4);
  EXPECT_NEAR(std::sqrt(ways / kRobots), std::sqrt(0.003 * way2 + 0.004 * turn2), 1e-4);
}

// What lasted of a drive: shares along and across, and the turn lost a metre.
struct Lasting {
  double along = 0.0, across = 0.0, skid_radpm = 0.0;
};

// Normalised squared error of the pose that a skidding robot reckons over four seconds at 1 m/s and
// 0.3 rad/s, where the ground takes of each interval what `lasting` says.
double SquaredErrorOf(const WheelOdometryModel& model, const Lasting& lasting, std::uint64_t key) {
  constexpr double kTurned_radps = 0.3;
  const double left = (1.0 - 0.25 * kTurned_radps) / 0.1,
               right = (1.0 + 0.25 * kTurned_radps) / 0.1;
  const auto wheels_at = [&](double time_s) {
    SensedWheels wheels = WheelsAt(time_s, left, right);
    wheels.skids = true;
    return wheels;
  };
  WheelOdometer odometer(model, key);
  odometer.Begin(wheels_at(0.0));
  WheelOdometryReading reading;
  Eigen::Vector3d truth = Eigen::Vector3d::Zero();
  for (int i = 1; i <= 800; ++i) {
    odometer.Add(wheels_at(i * kStep_s), kStep_s);
    const double way_m = kStep_s, turned_rad = kTurned_radps * kStep_s;
    const double turn_rad = (1.0 - lasting.along) * turned_rad - lasting.skid_radpm * way_m;
    const Eigen::Vector2d moved_m((1.0 - lasting.along) * way_m, -lasting.across * way_m);
    truth.head<2>() += Eigen::Rotation2Dd(truth.z() + 0.5 * turn_rad) * moved_m;
    truth.z() += turn_rad;
    if (i % 4 == 0) reading = odometer.Read(i / 4);
  }
  const Eigen::Vector3d error =
      Eigen::Vector3d(reading.position_m.x(), reading.position_m.y(), reading.heading_rad) - truth;
  return error.dot(reading.pose_covariance.inverse() * error);
}

// Of three degrees of freedom the mean is 3, and that of 400 runs has a standard deviation of 0.12.
TEST(WheelOdometryTest, ManyRunsErrAsMuchAsTheirPoseCovarianceSays) {
  WheelOdometryModel model;
  model.a1 = model.a3 = 1e-3;
  model.a2 = model.a4 = 1e-4;
  model.skid_radpm = 0.05;  // a turn so small that the covariance, of first order, holds
  constexpr int kRuns = 400;
  double with_lasting = 0.0, noise_alone = 0.0;
  WheelOdometryModel firm = model;
  firm.slip = firm.skid_radpm = 0.0;
  for (int i = 0; i < kRuns; ++i) {
    const Eigen::Vector3d drawn = NormalsAt(77, i);
    const Lasting lasting = {model.slip * drawn.x(), model.slip * drawn.y(),
                             model.skid_radpm * drawn.z()};
    with_lasting += SquaredErrorOf(model, lasting, i) / kRuns;
    noise_alone += SquaredErrorOf(firm, {}, i) / kRuns;
  }
  EXPECT_NEAR(with_lasting, 3.0, 0.5);
  EXPECT_NEAR(noise_alone, 3.0, 0.5);
}

TEST(WheelOdometryTest, WhatLastsGrowsWithTheWayAndNoiseWithItsRoot) {
  WheelOdometryModel model;
  model.a3 = 1e-3;
  model.slip = 0.0;
  const auto along = [](const WheelOdometryModel& of, int steps) {
    WheelOdometer odometer(of, 1);
    return std::sqrt(Drive(&odometer, steps, 10.0, 10.0).pose_covariance(0, 0));
  };
  EXPECT_NEAR(along(model, 1600) / along(model, 400), 2.0, 1e-6);
  model.slip = 0.02;
  model.a3 = 0.0;
  EXPECT_NEAR(along(model, 400), 0.02 * 2.0, 1e-6);
  EXPECT_NEAR(along(model, 1600), 0.02 * 8.0, 1e-6);
}

TEST(WheelOdometryTest, TicksMakeTheRateUncertainAndThePoseNoMoreWithTheWay) {
  WheelOdometryModel model;
  model.ticks_per_revolution = 4096.0;
  model.slip = model.skid_radpm = 0.0;
  const double tick_m = 0.1 * 2.0 * M_PI / 4096.0;
  double squares = 0.0, stated = 0.0;
  Eigen::Matrix3d first, last;
  WheelOdometer odometer(model, 1);
  odometer.Begin(WheelsAt(0.0, 9.81, 10.17));
  constexpr int kReadings = 1000;
  for (int i = 1; i <= 4 * kReadings; ++i) {
    odometer.Add(WheelsAt(i * kStep_s, 9.81, 10.17), kStep_s);
    if (i % 4 != 0) continue;
    const WheelOdometryReading reading = odometer.Read(i / 4);
    squares += std::pow(reading.yaw_rate_radps - 0.1 * 0.36 / 0.5, 2) / kReadings;
    stated = reading.twist_variances.z();
    (i == 4 ? first : last) = reading.pose_covariance;
  }
  EXPECT_NEAR(stated, std::pow(tick_m / 0.5 / 0.02, 2) / 3.0, 1e-9);
  EXPECT_NEAR(squares / stated, 1.0, 0.3);
  EXPECT_NEAR(first.trace(), last.trace(), 1e-12);
}

TEST(WheelOdometryTest, BaseLinkSwingsAroundTheAxleThatRolls) {
  const auto wheels_at = [](double time_s) {
    SensedWheels wheels = WheelsAt(time_s, -2.5, 2.5);  // 1 rad/s on the spot
    wheels.axle_m = -0.8;
    return wheels;
  };
  WheelOdometer odometer({}, 1);
  odometer.Begin(wheels_at(0.0));
  const int half = static_cast<int>(std::lround(M_PI / kStep_s));
  for (int i = 1; i <= half; ++i) odometer.Add(wheels_at(i * kStep_s), kStep_s);
  const WheelOdometryReading reading = odometer.Read(0);
  EXPECT_NEAR(reading.position_m.x(), -1.6, 1e-4);
  EXPECT_NEAR(reading.sideways_mps, 0.8, 1e-6);
  EXPECT_NEAR(reading.forward_mps, 0.0, 1e-9);
}

TEST(BumperTest, TellsTheHardestContactSinceItWasRead) {
  Bumper bumper({5.0});
  bumper.Add(4.0, {1.0, 0.0, 0.0});
  EXPECT_FALSE(bumper.Read().pressed);
  bumper.Add(30.0, {0.0, 2.0, 0.5});
  bumper.Add(12.0, {-1.0, 0.0, 0.0});
  bumper.Add(0.0, {0.0, 0.0, 0.0});
  const BumperReading reading = bumper.Read();
  EXPECT_TRUE(reading.pressed);
  EXPECT_EQ(reading.force_n, 30.0);
  EXPECT_NEAR(reading.bearing_rad, M_PI / 2.0, 1e-12);
  EXPECT_FALSE(bumper.Read().pressed);
  EXPECT_EQ(bumper.Read().force_n, 0.0);
}

}  // namespace
}  // namespace latticeworld
