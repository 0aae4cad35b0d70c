#ifndef LATTICEWORLD_ROS_SENSOR_TOPICS_H_
#define LATTICEWORLD_ROS_SENSOR_TOPICS_H_

#include <ros/ros.h>

#include <array>
#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "latticeworld/sensing/sensor_rig.h"
#include "latticeworld/species/species_catalogue.h"
#include "latticeworld_ros/robot_topics.h"

namespace latticeworld {

// How many listen to a topic; those of all topics together are counted in `all` for as long as the
// topic is there.
class ListenerCount {
 public:
  explicit ListenerCount(std::shared_ptr<std::atomic<int>> all) : all_(std::move(all)) {}
  ~ListenerCount() { *all_ -= own_; }
  ListenerCount(const ListenerCount&) = delete;
  ListenerCount& operator=(const ListenerCount&) = delete;

  void Add(int count) {
    own_ += count;
    *all_ += count;
  }
  bool any() const { return own_ > 0; }

 private:
  std::atomic<int> own_{0};
  const std::shared_ptr<std::atomic<int>> all_;
};

// A topic that knows, without asking the middleware, whether anybody listens.
struct SensorTopic {
  ros::Publisher publisher;
  std::shared_ptr<ListenerCount> listeners;  // null: there is no such topic

  bool wanted() const { return listeners != nullptr && listeners->any(); }
};
// A picture and the camera_info beside it.
struct PictureTopics {
  SensorTopic image, info;
  bool wanted() const { return image.wanted() || info.wanted(); }
};
struct SensorPublishers {
  SensorTopic data;  // of all but cameras
  PictureTopics colour, depth, classes, instances;

  SensorWish wish() const;
};
// By sensor; by robot.
using SuitePublishers = std::map<std::string, SensorPublishers>;
using SensorPublisherMap = std::map<std::string, std::shared_ptr<const SuitePublishers>>;

// The topics of robots' sensors, <robot>/<sensor> or, of cameras, <robot>/<sensor>/color/image_raw,
// depth/image_raw, labels/class and labels/instance with a camera_info beside each, and /tf_static
// with the places of all sensors on their robots.
class SensorTopics {
 public:
  // node: its callback queue counts listeners. suite: what every robot carries.
  SensorTopics(ros::NodeHandle node, std::shared_ptr<const SensorSuite> suite,
               std::shared_ptr<const SpeciesCatalogue> species);

  // Makes and ends topics until they are those of these robots. Talks to the master, some
  // milliseconds a topic; one thread calls it.
  void Apply(const std::vector<RobotWish>& robots);

  std::shared_ptr<const SensorPublisherMap> publishers() const;
  int listeners() const { return *listeners_; }  // of all topics together
  const std::shared_ptr<const SensorSuite>& suite() const { return suite_; }

 private:
  SuitePublishers Advertise(const RobotWish& robot);
  void PublishTransforms(const std::vector<RobotWish>& robots);
  const Species& SpeciesOf(const RobotWish& robot) const;
  template <typename Message>
  SensorTopic MakeTopic(const std::string& name, int queue_size);
  PictureTopics MakePicture(const std::string& base, const std::string& image);

  ros::NodeHandle node_;
  const std::shared_ptr<const SensorSuite> suite_;
  const std::shared_ptr<const SpeciesCatalogue> species_;
  const std::shared_ptr<std::atomic<int>> listeners_ = std::make_shared<std::atomic<int>>(0);
  ros::Publisher static_transforms_;
  std::vector<RobotWish> robots_;  // as applied last

  mutable std::mutex mutex_;
  std::shared_ptr<const SensorPublisherMap> publishers_ = std::make_shared<SensorPublisherMap>();
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_SENSOR_TOPICS_H_
