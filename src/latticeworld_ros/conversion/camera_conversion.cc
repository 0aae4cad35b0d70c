#include "latticeworld_ros/conversion/camera_conversion.h"

#include <sensor_msgs/distortion_models.h>
#include <sensor_msgs/image_encodings.h>

#include <cstdint>
#include <cstring>
#include <vector>

namespace latticeworld {
namespace {

namespace encodings = sensor_msgs::image_encodings;

// pixels: row by row, `channels` values a pixel.
template <typename T>
sensor_msgs::Image ToImage(const CameraModel& model, const std::vector<T>& pixels, int channels,
                           const std::string& encoding, const std::string& frame_id,
                           ros::Time stamp) {
  sensor_msgs::Image image;
  image.header.stamp = stamp;
  image.header.frame_id = frame_id;
  image.width = static_cast<std::uint32_t>(model.width);
  image.height = static_cast<std::uint32_t>(model.height);
  image.encoding = encoding;
  image.is_bigendian = 0;
  image.step = image.width * static_cast<std::uint32_t>(channels * sizeof(T));
  image.data.resize(pixels.size() * sizeof(T));
  if (!pixels.empty()) std::memcpy(image.data.data(), pixels.data(), image.data.size());
  return image;
}

}  // namespace

sensor_msgs::Image ToColourImage(const CameraModel& model, const CameraFrame& frame,
                                 const std::string& frame_id, ros::Time stamp) {
  return ToImage(model, frame.colour, 3, encodings::RGB8, frame_id, stamp);
}

sensor_msgs::Image ToDepthImage(const CameraModel& model, const CameraFrame& frame,
                                const std::string& frame_id, ros::Time stamp) {
  return ToImage(model, frame.depth_m, 1, encodings::TYPE_32FC1, frame_id, stamp);
}

sensor_msgs::Image ToClassImage(const CameraModel& model, const CameraFrame& frame,
                                const std::string& frame_id, ros::Time stamp) {
  return ToImage(model, frame.classes, 1, encodings::MONO8, frame_id, stamp);
}

sensor_msgs::Image ToInstanceImage(const CameraModel& model, const CameraFrame& frame,
                                   const std::string& frame_id, ros::Time stamp) {
  return ToImage(model, frame.instances, 1, encodings::TYPE_32SC1, frame_id, stamp);
}

sensor_msgs::CameraInfo ToCameraInfo(const CameraModel& model, const std::string& frame_id,
                                     ros::Time stamp) {
  sensor_msgs::CameraInfo info;
  info.header.stamp = stamp;
  info.header.frame_id = frame_id;
  info.width = static_cast<std::uint32_t>(model.width);
  info.height = static_cast<std::uint32_t>(model.height);
  info.distortion_model = sensor_msgs::distortion_models::PLUMB_BOB;
  info.D.assign(model.distortion.begin(), model.distortion.end());
  info.K = {model.fx_px, 0.0, model.cx_px, 0.0, model.fy_px, model.cy_px, 0.0, 0.0, 1.0};
  info.R = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  info.P = {model.fx_px, 0.0, model.cx_px, 0.0, 0.0, model.fy_px,
            model.cy_px, 0.0, 0.0,         0.0, 1.0, 0.0};
  return info;
}

}  // namespace latticeworld
