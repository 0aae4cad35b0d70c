#ifndef LATTICEWORLD_ROS_PUBLISHING_SENSOR_TOPICS_H_
#define LATTICEWORLD_ROS_PUBLISHING_SENSOR_TOPICS_H_

#include <ros/ros.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "latticeworld/sensing/sensor_rig.h"
#include "latticeworld/species/species_catalogue.h"
#include "latticeworld_ros/publishing/heard_publisher.h"
#include "latticeworld_ros/publishing/robot_topics.h"

namespace latticeworld {

// A picture and the camera_info beside it.
struct PictureTopics {
  HeardPublisher image, info;
  bool wanted() const { return image.IsHeard() || info.IsHeard(); }
};
struct SensorPublishers {
  HeardPublisher data;  // of all but cameras
  PictureTopics colour, depth, classes, instances;

  SensorWish wish() const;
};
// The publishers of a suite by sensor, and those of suites by robot.
using SuitePublishers = std::map<std::string, SensorPublishers>;
using SensorPublisherMap = std::map<std::string, std::shared_ptr<const SuitePublishers>>;

// The topics of robots' sensors, <robot>/<sensor> or, of cameras, <robot>/<sensor>/color/image_raw,
// depth/image_raw, labels/class and labels/instance with a camera_info beside each, and /tf_static
// with the places of all sensors on their robots.
class SensorTopics {
 public:
  // suite: what every robot carries.
  SensorTopics(ros::NodeHandle node, std::shared_ptr<const SensorSuite> suite,
               std::shared_ptr<const SpeciesCatalogue> species);

  // Makes and ends topics until they are those of the controllable ones of these agents: agents
  // that are decided for from outside carry nothing. Talks to the master, some milliseconds a
  // topic; one thread calls it.
  void Apply(const std::vector<RobotWish>& agents);

  std::shared_ptr<const SensorPublisherMap> publishers() const;
  int listeners() const;       // of all topics together
  bool has_listeners() const;  // whether there are any
  const std::shared_ptr<const SensorSuite>& suite() const { return suite_; }

 private:
  // A thousand topics are asked in every step whether anybody listens: in a row, not by the map.
  using TopicList = std::vector<HeardPublisher>;

  std::shared_ptr<const TopicList> topics() const;
  SuitePublishers Advertise(const RobotWish& robot);
  void PublishTransforms(const std::vector<RobotWish>& robots);
  const Species& SpeciesOf(const RobotWish& robot) const;
  template <typename Message>
  HeardPublisher MakeTopic(const std::string& name, int queue_size);
  PictureTopics MakePicture(const std::string& base, const std::string& image);

  ros::NodeHandle node_;
  const std::shared_ptr<const SensorSuite> suite_;
  const std::shared_ptr<const SpeciesCatalogue> species_;
  ros::Publisher static_transforms_;
  std::vector<RobotWish> robots_;  // as applied last

  mutable std::mutex mutex_;
  std::shared_ptr<const SensorPublisherMap> publishers_ = std::make_shared<SensorPublisherMap>();
  std::shared_ptr<const TopicList> topics_ = std::make_shared<TopicList>();  // of publishers_
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_PUBLISHING_SENSOR_TOPICS_H_
