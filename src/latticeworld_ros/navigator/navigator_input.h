#ifndef LATTICEWORLD_ROS_NAVIGATOR_NAVIGATOR_INPUT_H_
#define LATTICEWORLD_ROS_NAVIGATOR_NAVIGATOR_INPUT_H_

#include <nav_msgs/OccupancyGrid.h>
#include <ros/time.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>

#include <Eigen/Geometry>
#include <functional>
#include <optional>

#include "latticeworld/common/result.h"
#include "latticeworld/reference_navigator/navigator.h"

namespace latticeworld {

// What a navigator takes, from the messages that robots' drivers and maps send. Whatever the
// numbers in a message are, nothing here aborts.

// Errors: INVALID_ARGUMENT naming what the map is and what is legal: square, north up, its middle
// at the origin of its frame, within the limits of GridGeometry, -1 and 0..100.
Result<CostMap> ToCostMap(const nav_msgs::OccupancyGrid& map);

// Returns where a sensor was at a moment, frame map; nullopt: not known.
using SensorPoseAt = std::function<std::optional<Eigen::Isometry3d>(ros::Time)>;

// Readings beyond `range_m` are hits no more: of a scan their rays clear as far as that, of a cloud
// they are left out. A sweep takes time, and the sensor moves meanwhile: every reading is put where
// it was met and told in the frame that the sensor has at the end, to about 1/16 of the sweep.
// Errors: INVALID_ARGUMENT (what the message lacks, and what is legal), UNAVAILABLE (pose_at does
// not know where the sensor was).
Result<SensorSighting> ToSighting(const sensor_msgs::LaserScan& scan, double range_m,
                                  const SensorPoseAt& pose_at);
// Fields x, y and z (float32), and, where there is one, time (float32, seconds from the stamp).
Result<SensorSighting> ToSighting(const sensor_msgs::PointCloud2& cloud, double range_m,
                                  const SensorPoseAt& pose_at);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NAVIGATOR_NAVIGATOR_INPUT_H_
