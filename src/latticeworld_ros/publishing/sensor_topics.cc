#include "latticeworld_ros/publishing/sensor_topics.h"

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/MagneticField.h>
#include <sensor_msgs/NavSatFix.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>
#include <variant>

#include "latticeworld_ros/conversion/agent_conversion.h"
#include "latticeworld_ros/conversion/messages.h"
#include "latticeworld_ros/conversion/sensor_conversion.h"

namespace latticeworld {
namespace {

constexpr int kLargeQueue = 5;    // of pictures and clouds, which are megabytes
constexpr int kSmallQueue = 100;  // of what comes at hundreds of hertz

// z forward, x right, y down, in a frame whose x is forward and z up (REP 103).
Eigen::Isometry3d SensorFromOptical() {
  Eigen::Matrix3d rotation;
  rotation << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation;
  return pose;
}

void AppendTopics(const SensorPublishers& sensor, std::vector<HeardPublisher>* topics) {
  for (const HeardPublisher* topic :
       {&sensor.data, &sensor.colour.image, &sensor.colour.info, &sensor.depth.image,
        &sensor.depth.info, &sensor.classes.image, &sensor.classes.info, &sensor.instances.image,
        &sensor.instances.info}) {
    if (*topic) topics->push_back(*topic);
  }
}

}  // namespace

SensorWish SensorPublishers::wish() const {
  SensorWish wish;
  wish.pictures = {colour.wanted(), depth.wanted(), classes.wanted(), instances.wanted()};
  wish.any = data.IsHeard() || wish.pictures.colour || wish.pictures.depth ||
             wish.pictures.class_labels || wish.pictures.instance_labels;
  return wish;
}

SensorTopics::SensorTopics(ros::NodeHandle node, std::shared_ptr<const SensorSuite> suite,
                           std::shared_ptr<const SpeciesCatalogue> species)
    : node_(std::move(node)),
      suite_(std::move(suite)),
      species_(std::move(species)),
      static_transforms_(node_.advertise<tf2_msgs::TFMessage>("/tf_static", 10, /*latch=*/true)) {}

std::shared_ptr<const SensorPublisherMap> SensorTopics::publishers() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return publishers_;
}

std::shared_ptr<const SensorTopics::TopicList> SensorTopics::topics() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return topics_;
}

int SensorTopics::listeners() const {
  const std::shared_ptr<const TopicList> all = topics();
  return std::accumulate(all->begin(), all->end(), 0, [](int count, const HeardPublisher& topic) {
    return count + topic.listeners();
  });
}

bool SensorTopics::has_listeners() const {
  const std::shared_ptr<const TopicList> all = topics();
  return std::any_of(all->begin(), all->end(),
                     [](const HeardPublisher& topic) { return topic.IsHeard(); });
}

const Species& SensorTopics::SpeciesOf(const RobotWish& robot) const {
  const Species* species = species_->Find(robot.species);
  return species != nullptr ? *species : species_->Of(AgentCategory::kWheeledRobot);
}

void SensorTopics::Apply(const std::vector<RobotWish>& agents) {
  std::vector<RobotWish> robots;
  std::copy_if(agents.begin(), agents.end(), std::back_inserter(robots),
               [](const RobotWish& agent) { return agent.controllable; });
  if (suite_->sensors.empty() || robots == robots_) return;
  const std::shared_ptr<const SensorPublisherMap> before = publishers();
  auto after = std::make_shared<SensorPublisherMap>();
  for (const RobotWish& robot : robots) {
    const auto kept = before->find(robot.name);
    // Another species has other sensors: wheels, or none.
    const bool same = std::any_of(robots_.begin(), robots_.end(), [&](const RobotWish& known) {
      return known.name == robot.name && known.species == robot.species;
    });
    (*after)[robot.name] = kept != before->end() && same
                               ? kept->second
                               : std::make_shared<const SuitePublishers>(Advertise(robot));
  }
  auto all = std::make_shared<TopicList>();
  for (const auto& robot : *after) {
    for (const auto& sensor : *robot.second) AppendTopics(sensor.second, all.get());
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    publishers_ = std::move(after);
    topics_ = std::move(all);
  }
  robots_ = robots;
  PublishTransforms(robots);
}

template <typename Message>
HeardPublisher SensorTopics::MakeTopic(const std::string& name, int queue_size) {
  return HeardPublisher(node_.advertise<Message>(name, static_cast<std::uint32_t>(queue_size)));
}

PictureTopics SensorTopics::MakePicture(const std::string& base, const std::string& image) {
  return {MakeTopic<sensor_msgs::Image>(base + "/" + image, kLargeQueue),
          MakeTopic<sensor_msgs::CameraInfo>(base + "/camera_info", kLargeQueue)};
}

SuitePublishers SensorTopics::Advertise(const RobotWish& robot) {
  SuitePublishers suite;
  for (const SensorSpec& spec : suite_->sensors) {
    const std::string name = SensorFrameId(robot.name, spec);
    SensorPublishers sensor;
    if (const auto* lidar = std::get_if<LidarModel>(&spec.model)) {
      sensor.data = lidar->ring_elevations_rad.size() == 1
                        ? MakeTopic<sensor_msgs::LaserScan>(name, kSmallQueue)
                        : MakeTopic<sensor_msgs::PointCloud2>(name, kLargeQueue);
    } else if (const auto* camera = std::get_if<CameraSensor>(&spec.model)) {
      const CameraOutputs& outputs = camera->outputs;
      if (outputs.colour) sensor.colour = MakePicture(name + "/color", "image_raw");
      if (outputs.depth) sensor.depth = MakePicture(name + "/depth", "image_raw");
      // Both have the camera_info of the labels.
      if (outputs.class_labels || outputs.instance_labels) {
        const std::string labels = name + "/labels";
        const HeardPublisher info =
            MakeTopic<sensor_msgs::CameraInfo>(labels + "/camera_info", kLargeQueue);
        if (outputs.class_labels) {
          sensor.classes = {MakeTopic<sensor_msgs::Image>(labels + "/class", kLargeQueue), info};
        }
        if (outputs.instance_labels) {
          sensor.instances = {MakeTopic<sensor_msgs::Image>(labels + "/instance", kLargeQueue),
                              outputs.class_labels ? HeardPublisher() : info};
        }
      }
    } else if (std::holds_alternative<ImuModel>(spec.model)) {
      sensor.data = MakeTopic<sensor_msgs::Imu>(name, kSmallQueue);
    } else if (std::holds_alternative<GnssModel>(spec.model)) {
      sensor.data = MakeTopic<sensor_msgs::NavSatFix>(name, kSmallQueue);
    } else if (std::holds_alternative<MagnetometerModel>(spec.model)) {
      sensor.data = MakeTopic<sensor_msgs::MagneticField>(name, kSmallQueue);
    } else if (std::holds_alternative<WheelOdometryModel>(spec.model)) {
      if (!SpeciesOf(robot).vehicle) continue;  // it has no wheels
      sensor.data = MakeTopic<nav_msgs::Odometry>(name, kSmallQueue);
    } else {
      sensor.data = MakeTopic<latticeworld_msgs::Bumper>(name, kSmallQueue);
    }
    suite.emplace(spec.name, std::move(sensor));
  }
  return suite;
}

void SensorTopics::PublishTransforms(const std::vector<RobotWish>& robots) {
  // What stands still needs no time.
  const ros::Time stamp;
  tf2_msgs::TFMessage message;
  for (const RobotWish& robot : robots) {
    const double height_m = SpeciesOf(robot).height_m;
    for (const SensorSpec& spec : suite_->sensors) {
      const std::string frame = SensorFrameId(robot.name, spec);
      message.transforms.push_back(
          ToTransformStamped(BaseFromSensor(spec, height_m), stamp, BaseFrame(robot.name), frame));
      if (!std::holds_alternative<CameraSensor>(spec.model)) continue;
      message.transforms.push_back(
          ToTransformStamped(SensorFromOptical(), stamp, frame, OpticalFrameId(robot.name, spec)));
    }
  }
  static_transforms_.publish(message);
}

}  // namespace latticeworld
