#include "latticeworld_ros/conversion/sensor_conversion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "latticeworld_ros/conversion/camera_conversion.h"

namespace latticeworld {
namespace {

template <typename T>
T At(const std::vector<std::uint8_t>& data, std::size_t offset) {
  T value;
  std::memcpy(&value, &data[offset], sizeof(value));
  return value;
}

LidarModel HalfCircle() {
  LidarModel model;
  model.ring_elevations_rad = {0.0};
  model.columns = 4;
  model.first_azimuth_rad = -M_PI / 2.0;
  model.field_of_view_rad = M_PI;
  model.min_range_m = 0.1;
  model.max_range_m = 30.0;
  return model;
}

TEST(SensorConversionTest, AScanIsStampedWithItsFirstBeam) {
  LidarSweep sweep;
  sweep.begin_s = 1.0;
  sweep.end_s = 1.1;
  sweep.columns = 4;
  sweep.ranges_m = {1.0f, std::numeric_limits<float>::infinity(), 3.0f, 4.0f};
  sweep.intensities = {10.0f, 0.0f, 30.0f, 40.0f};
  const auto scan = ToLaserScan(sweep, HalfCircle(), 10.0, "robot/scan", ros::Time(50, 0));
  EXPECT_EQ(scan.header.stamp, ros::Time(49, 900000000));
  EXPECT_EQ(scan.header.frame_id, "robot/scan");
  EXPECT_FLOAT_EQ(scan.angle_min, -M_PI / 2.0);
  EXPECT_FLOAT_EQ(scan.angle_increment, M_PI / 4.0);
  EXPECT_FLOAT_EQ(scan.angle_max, M_PI / 4.0);
  EXPECT_FLOAT_EQ(scan.time_increment, 0.1 / 8.0);  // an eighth of the turn from beam to beam
  EXPECT_FLOAT_EQ(scan.scan_time, 0.1);
  EXPECT_EQ(scan.ranges, sweep.ranges_m);
  EXPECT_EQ(scan.intensities, sweep.intensities);
}

TEST(SensorConversionTest, PointsLieAsDriversLayThemOut) {
  LidarSweep sweep;
  sweep.begin_s = 2.0;
  sweep.end_s = 2.1;
  sweep.rings = 16;
  sweep.points = {{1.0f, 2.0f, 3.0f, 99.0f, 7, 0, 0}, {4.0f, 5.0f, 6.0f, 55.0f, 15, 9, 60000000}};
  const auto cloud = ToPointCloud2(sweep, "robot/points", ros::Time(9, 0));
  EXPECT_EQ(cloud.header.stamp, ros::Time(9, 0));
  EXPECT_EQ(cloud.width, 2u);
  EXPECT_EQ(cloud.height, 1u);
  EXPECT_EQ(cloud.point_step, 22u);
  ASSERT_EQ(cloud.data.size(), 44u);
  ASSERT_EQ(cloud.fields.size(), 6u);
  EXPECT_EQ(At<float>(cloud.data, 22 + cloud.fields[0].offset), 4.0f);
  EXPECT_EQ(At<float>(cloud.data, 22 + cloud.fields[2].offset), 6.0f);
  EXPECT_EQ(At<float>(cloud.data, 22 + cloud.fields[3].offset), 55.0f);
  EXPECT_EQ(At<std::uint16_t>(cloud.data, 22 + cloud.fields[4].offset), 15);
  // The stamp and a point's time are the moment of its firing.
  EXPECT_FLOAT_EQ(At<float>(cloud.data, cloud.fields[5].offset), -0.1f);
  EXPECT_FLOAT_EQ(At<float>(cloud.data, 22 + cloud.fields[5].offset), -0.04f);
}

// LIO-SAM, FAST-LIO and others take the stamp for the begin of the scan.
TEST(SensorConversionTest, PointTimesMayCountFromTheRevolutionsBegin) {
  LidarSweep sweep;
  sweep.begin_s = 2.0;
  sweep.end_s = 2.1;
  sweep.rings = 16;
  sweep.points = {{1.0f, 2.0f, 3.0f, 99.0f, 7, 0, 0}, {4.0f, 5.0f, 6.0f, 55.0f, 15, 9, 60000000}};
  const auto cloud = ToPointCloud2(sweep, "robot/points", ros::Time(9, 0), PointTimes::kBegin);
  EXPECT_EQ(cloud.header.stamp, ros::Time(8, 900000000));
  EXPECT_EQ(At<float>(cloud.data, cloud.fields[5].offset), 0.0f);
  EXPECT_FLOAT_EQ(At<float>(cloud.data, 22 + cloud.fields[5].offset), 0.06f);
}

TEST(SensorConversionTest, AnImuWithoutOrientationSaysSo) {
  ImuReading reading;
  reading.acceleration_mps2 = {0.1, 0.2, 9.81};
  reading.angular_velocity_radps = {1.0, 2.0, 3.0};
  ImuModel model;
  model.gyroscope.density = 0.01;
  const auto imu = ToImu(reading, model, 100.0, "robot/imu", ros::Time(1, 0));
  EXPECT_GT(imu.orientation_covariance[0], 0.0);
  EXPECT_EQ(imu.orientation.w, 1.0);
  EXPECT_NEAR(imu.angular_velocity_covariance[4], 0.01 * 0.01 * 100.0, 1e-12);
  EXPECT_EQ(imu.angular_velocity_covariance[1], 0.0);
  EXPECT_EQ(imu.linear_acceleration.z, 9.81);
  model.gives_orientation = false;
  EXPECT_EQ(ToImu(reading, model, 100.0, "robot/imu", ros::Time(1, 0)).orientation_covariance[0],
            -1.0);
}

TEST(SensorConversionTest, AFixHasVariancesEastNorthAndUp) {
  GnssReading reading;
  reading.latitude_deg = 48.5;
  reading.longitude_deg = 11.25;
  reading.altitude_m = 520.0;
  reading.stddev_m = {1.0, 2.0, 3.0};
  const auto fix = ToNavSatFix(reading, "robot/fix", ros::Time(1, 0));
  EXPECT_EQ(fix.latitude, 48.5);
  EXPECT_EQ(fix.longitude, 11.25);
  EXPECT_EQ(fix.altitude, 520.0);
  EXPECT_EQ(fix.position_covariance[0], 1.0);
  EXPECT_EQ(fix.position_covariance[4], 4.0);
  EXPECT_EQ(fix.position_covariance[8], 9.0);
  EXPECT_EQ(fix.position_covariance_type, sensor_msgs::NavSatFix::COVARIANCE_TYPE_DIAGONAL_KNOWN);
}

TEST(SensorConversionTest, WheelOdometryTurnsAboutTheVertical) {
  WheelOdometryReading reading;
  reading.position_m = {3.0, -1.0};
  reading.heading_rad = M_PI / 2.0;
  reading.forward_mps = 2.0;
  reading.yaw_rate_radps = 0.5;
  reading.sideways_mps = -0.25;
  reading.twist_variances = {0.04, 0.01, 0.0};
  const auto odometry = ToOdometry(reading, "robot/odom", "robot/base_link", ros::Time(1, 0));
  EXPECT_EQ(odometry.child_frame_id, "robot/base_link");
  EXPECT_EQ(odometry.pose.pose.position.x, 3.0);
  EXPECT_NEAR(odometry.pose.pose.orientation.z, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(odometry.pose.pose.orientation.w, std::sqrt(0.5), 1e-12);
  EXPECT_EQ(odometry.twist.twist.linear.x, 2.0);
  EXPECT_EQ(odometry.twist.twist.linear.y, -0.25);
  EXPECT_NEAR(odometry.twist.covariance[0], 0.04, 1e-6);
  EXPECT_LT(odometry.twist.covariance[35], 1e-6);
}

TEST(SensorConversionTest, WheelOdometryHasThePosesCovarianceAndNoVarianceIsZero) {
  WheelOdometryReading reading;
  reading.pose_covariance << 0.3, 0.01, 0.02, 0.01, 0.4, 0.03, 0.02, 0.03, 0.05;
  const auto odometry = ToOdometry(reading, "robot/odom", "robot/base_link", ros::Time(1, 0));
  const auto& pose = odometry.pose.covariance;
  EXPECT_NEAR(pose[0], 0.3, 2e-6);
  EXPECT_NEAR(pose[7], 0.4, 2e-6);
  EXPECT_NEAR(pose[35], 0.05, 2e-6);
  EXPECT_EQ(pose[1], 0.01);   // x y
  EXPECT_EQ(pose[5], 0.02);   // x yaw
  EXPECT_EQ(pose[31], 0.03);  // yaw y
  const auto at_first =
      ToOdometry(WheelOdometryReading(), "robot/odom", "robot/base_link", ros::Time(1, 0));
  for (std::size_t i = 0; i < 36; i += 7) {
    EXPECT_GT(at_first.pose.covariance[i], 0.0);
    EXPECT_GT(at_first.twist.covariance[i], 0.0);
  }
}

TEST(CameraConversionTest, PicturesKeepTheirPixels) {
  CameraModel model;
  model.width = 2;
  model.height = 1;
  CameraFrame frame;
  frame.colour = {1, 2, 3, 4, 5, 6};
  frame.depth_m = {1.5f, -std::numeric_limits<float>::infinity()};
  frame.classes = {8, 9};
  frame.instances = {70000, 0};
  const auto colour = ToColourImage(model, frame, "robot/camera_optical", ros::Time(1, 0));
  EXPECT_EQ(colour.encoding, "rgb8");
  EXPECT_EQ(colour.step, 6u);
  EXPECT_EQ(colour.data, frame.colour);
  const auto depth = ToDepthImage(model, frame, "robot/camera_optical", ros::Time(1, 0));
  EXPECT_EQ(depth.encoding, "32FC1");
  EXPECT_EQ(depth.step, 8u);
  EXPECT_EQ(At<float>(depth.data, 0), 1.5f);
  EXPECT_EQ(At<float>(depth.data, 4), -std::numeric_limits<float>::infinity());
  EXPECT_EQ(ToClassImage(model, frame, "f", ros::Time(1, 0)).encoding, "mono8");
  const auto instances = ToInstanceImage(model, frame, "f", ros::Time(1, 0));
  EXPECT_EQ(instances.encoding, "32SC1");
  EXPECT_EQ(At<std::int32_t>(instances.data, 0), 70000);
}

TEST(CameraConversionTest, CameraInfoIsThePinholeAndItsDistortion) {
  CameraModel model;
  model.fx_px = 300.0;
  model.fy_px = 310.0;
  model.cx_px = 160.5;
  model.cy_px = 119.0;
  model.distortion = {0.1, -0.2, 0.001, 0.002, 0.03};
  const auto info = ToCameraInfo(model, "robot/camera_optical", ros::Time(1, 0));
  EXPECT_EQ(info.width, 320u);
  EXPECT_EQ(info.height, 240u);
  EXPECT_EQ(info.distortion_model, "plumb_bob");
  EXPECT_EQ(info.D, std::vector<double>({0.1, -0.2, 0.001, 0.002, 0.03}));
  EXPECT_EQ(info.K[0], 300.0);
  EXPECT_EQ(info.K[2], 160.5);
  EXPECT_EQ(info.K[4], 310.0);
  EXPECT_EQ(info.P[5], 310.0);
  EXPECT_EQ(info.P[6], 119.0);
  EXPECT_EQ(info.R[8], 1.0);
}

}  // namespace
}  // namespace latticeworld
