#ifndef LATTICEWORLD_ROS_VIEWER_VIEWER_CALLS_H_
#define LATTICEWORLD_ROS_VIEWER_VIEWER_CALLS_H_

#include <geometry_msgs/Twist.h>
#include <ros/ros.h>

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>

#include "latticeworld/viewer/viewer_backend.h"
#include "latticeworld_ros/conversion/messages.h"
#include "latticeworld_ros/viewer/call_queue.h"

namespace latticeworld {

// Does what clients of the viewer ask for by the services and topics of world_server. Each call
// waits on a thread of this class, never on the caller's.
class ViewerCalls {
 public:
  // on_pause, on_speed: told of what has been done, from any thread.
  ViewerCalls(ros::NodeHandle node, std::function<void(bool)> on_pause,
              std::function<void(double)> on_speed);
  ~ViewerCalls() { Stop(); }
  ViewerCalls(const ViewerCalls&) = delete;
  ViewerCalls& operator=(const ViewerCalls&) = delete;

  // Everything but subscribe and authenticate. Never waits.
  void Do(const ViewerRequest& request, ViewerBackend::Done done);
  // Whom clients may drive; others are refused.
  void SetRobots(std::set<std::string> robots);
  // Calls under way end once ROS shuts down; to be called after that, or when there are none.
  void Stop();

 private:
  struct Robot {
    ros::Publisher velocity, strike;
  };

  ViewerReply Call(const ViewerRequest& request);
  ViewerReply Generate(const ViewerRequest& request);
  ViewerReply SetWeather(const ViewerRequest& request);
  Status Trigger(const std::string& service);
  void Drive(const ViewerRequest& request, ViewerBackend::Done done);
  void Send(const ViewerRequest& request);
  Status CheckRobot(const std::string& robot);

  ros::NodeHandle node_;
  std::function<void(bool)> on_pause_;
  std::function<void(double)> on_speed_;
  std::atomic<bool> cancel_{false};

  std::mutex mutex_;
  std::set<std::string> robots_;                 // guarded by mutex_
  std::map<std::string, ViewerRequest> wanted_;  // guarded by mutex_: newest not sent yet, by robot
  std::map<std::string, Robot> publishers_;      // of the thread of `driving_` alone

  CallQueue making_{1, 4};    // worlds: one at a time, long
  CallQueue calling_{2, 32};  // everything else
  CallQueue driving_{1, 64};
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_VIEWER_VIEWER_CALLS_H_
