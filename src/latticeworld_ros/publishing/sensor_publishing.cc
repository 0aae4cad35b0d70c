#include "latticeworld_ros/publishing/sensor_publishing.h"

#include <variant>

#include "latticeworld_ros/conversion/agent_conversion.h"
#include "latticeworld_ros/conversion/camera_conversion.h"
#include "latticeworld_ros/conversion/sensor_conversion.h"

namespace latticeworld {
namespace {

// Publishes a reading by its type.
struct Publisher {
  const SensorFrame& frame;
  const SensorPublishers& topics;
  ros::Time stamp;
  PointTimes point_times;

  const SensorSpec& spec() const { return *frame.sensor; }
  std::string frame_id() const { return SensorFrameId(frame.robot, spec()); }
  template <typename Model>
  const Model& model() const {
    return std::get<Model>(spec().model);
  }

  void operator()(const LidarSweep& sweep) const {
    if (sweep.rings == 1) {
      topics.data.Publish([&] {
        return ToLaserScan(sweep, model<LidarModel>(), spec().rate_hz, frame_id(), stamp);
      });
    } else {
      topics.data.Publish([&] { return ToPointCloud2(sweep, frame_id(), stamp, point_times); });
    }
  }
  void operator()(const CameraFrame& pictures) const {
    Picture(topics.colour, pictures.colour.empty(), ToColourImage, pictures);
    Picture(topics.depth, pictures.depth_m.empty(), ToDepthImage, pictures);
    Picture(topics.classes, pictures.classes.empty(), ToClassImage, pictures);
    Picture(topics.instances, pictures.instances.empty(), ToInstanceImage, pictures);
  }
  void operator()(const ImuReading& reading) const {
    topics.data.Publish(
        [&] { return ToImu(reading, model<ImuModel>(), spec().rate_hz, frame_id(), stamp); });
  }
  void operator()(const GnssReading& reading) const {
    topics.data.Publish([&] { return ToNavSatFix(reading, frame_id(), stamp); });
  }
  void operator()(const MagnetometerReading& reading) const {
    topics.data.Publish(
        [&] { return ToMagneticField(reading, model<MagnetometerModel>(), frame_id(), stamp); });
  }
  void operator()(const WheelOdometryReading& reading) const {
    topics.data.Publish(
        [&] { return ToOdometry(reading, OdomFrame(frame.robot), BaseFrame(frame.robot), stamp); });
  }
  void operator()(const BumperReading& reading) const {
    topics.data.Publish([&] { return ToBumper(reading, frame_id(), stamp); });
  }

 private:
  template <typename Convert>
  void Picture(const PictureTopics& picture, bool is_missing, Convert convert,
               const CameraFrame& pictures) const {
    if (is_missing) return;
    const CameraModel& camera = model<CameraSensor>().model;
    const std::string optical = OpticalFrameId(frame.robot, spec());
    picture.image.Publish([&] { return convert(camera, pictures, optical, stamp); });
    picture.info.Publish([&] { return ToCameraInfo(camera, optical, stamp); });
  }
};

}  // namespace

const SensorPublishers* SensorPublisherFinder::Find(const std::string& robot,
                                                    const SensorSpec& sensor) {
  const auto is_here = [&] { return suite_ != publishers_.end() && suite_->first == robot; };
  if (!is_here() && suite_ != publishers_.end()) ++suite_;
  if (!is_here()) suite_ = publishers_.find(robot);
  if (!is_here()) return nullptr;
  const auto found = suite_->second->find(sensor.name);
  return found == suite_->second->end() ? nullptr : &found->second;
}

void Publish(const SensorFrame& frame, ros::Time stamp, const SensorPublishers& topics,
             PointTimes point_times) {
  std::visit(Publisher{frame, topics, stamp, point_times}, frame.reading);
}

}  // namespace latticeworld
