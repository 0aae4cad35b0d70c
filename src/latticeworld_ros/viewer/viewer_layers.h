#ifndef LATTICEWORLD_ROS_VIEWER_VIEWER_LAYERS_H_
#define LATTICEWORLD_ROS_VIEWER_VIEWER_LAYERS_H_

#include <nav_msgs/Path.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>

#include <Eigen/Geometry>
#include <condition_variable>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "latticeworld/viewer/server/viewer_server.h"
#include "latticeworld/viewer/viewer_backend.h"

namespace latticeworld {

// Lidar points and paths for clients: subscribes to them while a client looks at them, and only
// then, for world_server computes what somebody listens to. The master is asked on a thread of
// its own; messages come on the queue of `node`.
class ViewerLayers {
 public:
  ViewerLayers(ros::NodeHandle node, ViewerServer* server);
  ~ViewerLayers() { Stop(); }
  ViewerLayers(const ViewerLayers&) = delete;
  ViewerLayers& operator=(const ViewerLayers&) = delete;

  // Any thread may call this; it never waits.
  void SetDemand(const LayerDemand& demand);
  // Takes where robots stand, map_from_base, by name; on the queue's thread.
  void SetPoses(std::map<std::string, Eigen::Isometry3d> poses);
  void Stop();

 private:
  struct Mounting {
    std::string parent;
    Eigen::Isometry3d parent_from_child = Eigen::Isometry3d::Identity();
  };
  struct Listened {
    ros::Subscriber subscriber;
    bool is_path = false;
    std::string robot;
  };

  void Run();
  // Topics that the demand asks for, with their types: {topic, {type, robot}}.
  std::map<std::string, std::pair<std::string, std::string>> WantedTopics(
      const LayerDemand& demand);
  void Listen(const LayerDemand& demand);
  void OnStaticTransforms(const tf2_msgs::TFMessage& message);
  void OnPath(const std::string& topic, const nav_msgs::Path& path);
  template <typename Message>
  void OnPoints(const std::string& robot, const Message& message);
  // map_from_sensor; false: it is not known where the frame is.
  bool PoseOf(const std::string& frame, const std::string& robot, Eigen::Isometry3d* pose) const;

  ros::NodeHandle node_;
  ViewerServer* server_;
  ros::Subscriber static_transforms_;

  // Only the queue's thread touches these.
  std::map<std::string, Eigen::Isometry3d> poses_;
  std::map<std::string, Mounting> mountings_;  // by child frame
  std::map<std::string, double> last_wall_s_;  // when it was shown last, by topic or robot

  // Only the thread touches these.
  std::map<std::string, Listened> listened_;  // by topic

  std::mutex mutex_;
  std::condition_variable changed_;
  LayerDemand demand_;                  // guarded by mutex_
  std::vector<std::string> robots_;     // guarded by mutex_
  bool is_new_ = false, stop_ = false;  // guarded by mutex_
  std::thread thread_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_VIEWER_VIEWER_LAYERS_H_
