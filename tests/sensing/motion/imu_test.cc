#include "latticeworld/sensing/motion/imu.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace latticeworld {
namespace {

using Eigen::Vector3d;

constexpr double kGravity = 9.81;
constexpr double kStep_s = 0.005;

PointMotion At(const Eigen::Quaterniond& orientation, const Vector3d& velocity_mps) {
  PointMotion motion;
  motion.map_from_sensor.linear() = orientation.toRotationMatrix();
  motion.velocity_mps = velocity_mps;
  return motion;
}

InertialIntegral Between(const PointMotion& before, const PointMotion& now) {
  InertialIntegral integral;
  integral.Add(before, now, kStep_s, kGravity);
  return integral;
}

TEST(ImuTest, AtRestItFeelsTheGroundPushItUp) {
  const PointMotion rest = At(Eigen::Quaterniond::Identity(), Vector3d::Zero());
  const InertialIntegral integral = Between(rest, rest);
  EXPECT_TRUE(integral.MeanSpecificForce().isApprox(Vector3d(0.0, 0.0, kGravity), 1e-12));
  EXPECT_TRUE(integral.MeanRate().isZero(1e-12));
}

TEST(ImuTest, TiltedItFeelsTheSameInItsOwnFrame) {
  // Nose down by 30 degrees: the push from the ground comes from behind and below.
  const Eigen::Quaterniond down(Eigen::AngleAxisd(M_PI / 6.0, Vector3d::UnitY()));
  const PointMotion rest = At(down, Vector3d::Zero());
  const Vector3d force = Between(rest, rest).MeanSpecificForce();
  EXPECT_TRUE(force.isApprox(kGravity * Vector3d(-0.5, 0.0, std::sqrt(0.75)), 1e-12));
}

TEST(ImuTest, InFreeFallItFeelsNothing) {
  const Eigen::Quaterniond any = Eigen::Quaterniond(0.3, 0.5, -0.2, 0.7).normalized();
  const Vector3d falling(1.0, 2.0, -3.0);
  const InertialIntegral integral =
      Between(At(any, falling), At(any, falling - Vector3d(0.0, 0.0, kGravity * kStep_s)));
  EXPECT_TRUE(integral.MeanSpecificForce().isZero(1e-10));
}

TEST(ImuTest, OnATurntableItFeelsTheCentripetalForce) {
  // 2 rad/s, half a metre ahead of the axis.
  const double rate = 2.0, arm_m = 0.5;
  Eigen::Isometry3d base_from_sensor = Eigen::Isometry3d::Identity();
  base_from_sensor.translation() = Vector3d(arm_m, 0.0, 0.2);
  InertialIntegral integral;
  std::vector<PointMotion> motions;
  for (int i = 0; i <= 20; ++i) {
    Eigen::Isometry3d map_from_base = Eigen::Isometry3d::Identity();
    map_from_base.rotate(Eigen::AngleAxisd(rate * i * kStep_s, Vector3d::UnitZ()));
    motions.push_back(
        MotionOf(map_from_base, Vector3d::Zero(), rate * Vector3d::UnitZ(), base_from_sensor));
  }
  for (int i = 0; i < 20; ++i) integral.Add(motions[i], motions[i + 1], kStep_s, kGravity);
  EXPECT_NEAR(integral.duration_s(), 0.1, 1e-12);
  EXPECT_TRUE(integral.MeanRate().isApprox(Vector3d(0.0, 0.0, rate), 1e-9));
  // Chords of 0.01 rad are shorter than arcs by 4e-6.
  const Vector3d expected(-rate * rate * arm_m, 0.0, kGravity);
  EXPECT_TRUE(integral.MeanSpecificForce().isApprox(expected, 1e-5));
}

TEST(ImuTest, ATurnOverTheDateLineOfAnglesStaysSmall) {
  const auto yaw = [](double angle) {
    return At(Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vector3d::UnitZ())), Vector3d::Zero());
  };
  const Vector3d rate = Between(yaw(M_PI - 0.01), yaw(-M_PI + 0.01)).MeanRate();
  EXPECT_NEAR(rate.z(), 0.02 / kStep_s, 1e-6);
}

TEST(ImuTest, NoiseHasItsDensityAndBiasesTheirSpread) {
  ImuModel model;
  model.gyroscope = {0.001, 0.02, 0.0, 300.0};
  const double rate_hz = 100.0;
  const PointMotion rest = At(Eigen::Quaterniond::Identity(), Vector3d::Zero());
  double turn_on = 0.0, white = 0.0;
  constexpr int kSensors = 400, kReadings = 200;
  for (int sensor = 0; sensor < kSensors; ++sensor) {
    ImuErrors errors(model, rate_hz, sensor);
    Vector3d sum = Vector3d::Zero(), squares = Vector3d::Zero();
    for (int k = 0; k < kReadings; ++k) {
      const ImuReading reading = errors.Read(Between(rest, rest), k);
      sum += reading.angular_velocity_radps;
      squares += reading.angular_velocity_radps.cwiseAbs2();
      EXPECT_EQ(reading.acceleration_mps2.z(), kGravity);
    }
    const Vector3d mean = sum / kReadings;
    turn_on += mean.squaredNorm() / 3.0;
    white += (squares / kReadings - mean.cwiseAbs2()).sum() / 3.0;
  }
  // density * sqrt(rate) = 0.01 a reading; mean of 200: 0.0007.
  EXPECT_NEAR(std::sqrt(white / kSensors), 0.01, 0.0002);
  EXPECT_NEAR(std::sqrt(turn_on / kSensors), 0.02, 0.002);
}

TEST(ImuTest, AllanDeviationFallsAsWhiteNoiseAndRisesWithTheBias) {
  ImuModel model;
  model.accelerometer = {0.002, 0.0, 0.003, 40.0};
  ImuErrors errors(model, 50.0, 11);
  const PointMotion rest = At(Eigen::Quaterniond::Identity(), Vector3d::Zero());
  std::vector<double> readings;
  for (int k = 0; k < 200000; ++k) {
    readings.push_back(errors.Read(Between(rest, rest), k).acceleration_mps2.x());
  }
  const auto allan = [&](int of) {  // deviation of means of that many readings
    double squares = 0.0, last = 0.0;
    int count = 0;
    for (std::size_t i = 0; i + of <= readings.size(); i += of) {
      double mean = 0.0;
      for (int k = 0; k < of; ++k) mean += readings[i + k] / of;
      if (i > 0) squares += (mean - last) * (mean - last), ++count;
      last = mean;
    }
    return std::sqrt(0.5 * squares / count);
  };
  EXPECT_NEAR(allan(5), 0.002 / std::sqrt(0.1), 0.0004);  // density / sqrt(time)
  EXPECT_NEAR(allan(50), 0.002 / std::sqrt(1.0), 0.0003);
  // Longer than its correlation time it is the bias that is left.
  EXPECT_GT(allan(2500), 1.5 * 0.002 / std::sqrt(50.0));
}

TEST(ImuTest, ReadingsAreCutAtTheModelsLimits) {
  ImuModel model;
  model.max_rate_radps = 5.0;
  model.max_acceleration_mps2 = 50.0;
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.1, Vector3d::UnitZ()));
  const InertialIntegral integral = Between(At(Eigen::Quaterniond::Identity(), Vector3d::Zero()),
                                            At(turned, Vector3d(9.0, 0.0, 0.0)));
  const ImuReading reading = ImuErrors(model, 100.0, 1).Read(integral, 0);
  EXPECT_EQ(reading.angular_velocity_radps.z(), 5.0);
  EXPECT_EQ(reading.acceleration_mps2.x(), 50.0);
}

}  // namespace
}  // namespace latticeworld
