#ifndef LATTICEWORLD_ROS_CONVERSION_CAMERA_CONVERSION_H_
#define LATTICEWORLD_ROS_CONVERSION_CAMERA_CONVERSION_H_

#include <ros/time.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <string>

#include "latticeworld/sensing/camera/camera_model.h"

namespace latticeworld {

// The pictures of a frame as messages; each needs its picture to be there. frame_id: of the optical
// frame (z forward, x right, y down).
sensor_msgs::Image ToColourImage(const CameraModel& model, const CameraFrame& frame,
                                 const std::string& frame_id, ros::Time stamp);  // rgb8
// 32FC1 [m]; infinity, NaN and -infinity as REP 117 has them for ranges.
sensor_msgs::Image ToDepthImage(const CameraModel& model, const CameraFrame& frame,
                                const std::string& frame_id, ros::Time stamp);
sensor_msgs::Image ToClassImage(const CameraModel& model, const CameraFrame& frame,
                                const std::string& frame_id, ros::Time stamp);  // mono8
sensor_msgs::Image ToInstanceImage(const CameraModel& model, const CameraFrame& frame,
                                   const std::string& frame_id, ros::Time stamp);  // 32SC1

// Distortion model "plumb_bob"; R is the identity, P is K.
sensor_msgs::CameraInfo ToCameraInfo(const CameraModel& model, const std::string& frame_id,
                                     ros::Time stamp);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_CAMERA_CONVERSION_H_
