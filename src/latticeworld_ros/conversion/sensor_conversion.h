#ifndef LATTICEWORLD_ROS_CONVERSION_SENSOR_CONVERSION_H_
#define LATTICEWORLD_ROS_CONVERSION_SENSOR_CONVERSION_H_

#include <nav_msgs/Odometry.h>
#include <ros/time.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/MagneticField.h>
#include <sensor_msgs/NavSatFix.h>
#include <sensor_msgs/PointCloud2.h>

#include <string>

#include "latticeworld/sensing/sensor_suite.h"
#include "latticeworld_ros/conversion/messages.h"
#include "latticeworld_ros/conversion/point_times.h"

namespace latticeworld {

// Rounds to the nanosecond, where ros::Duration(double) cuts.
ros::Duration DurationOf(double seconds);

// <robot>/<sensor>, and of its pictures <robot>/<sensor>_optical.
std::string SensorFrameId(const std::string& robot, const SensorSpec& sensor);
std::string OpticalFrameId(const std::string& robot, const SensorSpec& sensor);

// end: the stamp of the sweep's end. A scan's own stamp is that of its first beam, as LaserScan
// defines it, a moment before.
sensor_msgs::LaserScan ToLaserScan(const LidarSweep& sweep, const LidarModel& model, double rate_hz,
                                   const std::string& frame_id, ros::Time end);
// The layout of Velodyne's and other drivers: x, y, z, intensity (float32), ring (uint16), time
// (float32): seconds from the stamp to the point's firing. Unordered, dense. end: of the sweep;
// that or its begin is the stamp, as `times` says.
sensor_msgs::PointCloud2 ToPointCloud2(const LidarSweep& sweep, const std::string& frame_id,
                                       ros::Time end, PointTimes times = PointTimes::kEnd);

// Covariances are those of the model's white noise at that rate.
sensor_msgs::Imu ToImu(const ImuReading& reading, const ImuModel& model, double rate_hz,
                       const std::string& frame_id, ros::Time stamp);
sensor_msgs::NavSatFix ToNavSatFix(const GnssReading& reading, const std::string& frame_id,
                                   ros::Time stamp);
sensor_msgs::MagneticField ToMagneticField(const MagnetometerReading& reading,
                                           const MagnetometerModel& model,
                                           const std::string& frame_id, ros::Time stamp);
// frame_id: where the robot began; child_frame_id: its base_link. Covariances are the reading's;
// of what wheels know nothing of (z, roll, pitch) the variance is 1e6, and none is 0.
nav_msgs::Odometry ToOdometry(const WheelOdometryReading& reading, const std::string& frame_id,
                              const std::string& child_frame_id, ros::Time stamp);
latticeworld_msgs::Bumper ToBumper(const BumperReading& reading, const std::string& frame_id,
                                   ros::Time stamp);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_SENSOR_CONVERSION_H_
