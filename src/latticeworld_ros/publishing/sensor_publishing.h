#ifndef LATTICEWORLD_ROS_PUBLISHING_SENSOR_PUBLISHING_H_
#define LATTICEWORLD_ROS_PUBLISHING_SENSOR_PUBLISHING_H_

#include <ros/time.h>

#include <string>

#include "latticeworld/sensing/sensor_rig.h"
#include "latticeworld_ros/conversion/point_times.h"
#include "latticeworld_ros/publishing/sensor_topics.h"

namespace latticeworld {

// Finds topics of sensors, quickest where it is asked for one robot after the other, as sorted.
class SensorPublisherFinder {
 public:
  // publishers: outlives the finder.
  explicit SensorPublisherFinder(const SensorPublisherMap& publishers)
      : publishers_(publishers), suite_(publishers.begin()) {}

  // Returns the topics of a robot's sensor; nullptr: it has none.
  const SensorPublishers* Find(const std::string& robot, const SensorSpec& sensor);

 private:
  const SensorPublisherMap& publishers_;
  SensorPublisherMap::const_iterator suite_;  // of the robot that was asked for last
};

// Publishes what a sensor gave on those of its topics that anybody listens to. stamp: of when it
// was complete; point_times: of clouds.
void Publish(const SensorFrame& frame, ros::Time stamp, const SensorPublishers& topics,
             PointTimes point_times);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_PUBLISHING_SENSOR_PUBLISHING_H_
