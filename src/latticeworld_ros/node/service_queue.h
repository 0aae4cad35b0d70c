#ifndef LATTICEWORLD_ROS_NODE_SERVICE_QUEUE_H_
#define LATTICEWORLD_ROS_NODE_SERVICE_QUEUE_H_

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <boost/function.hpp>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace latticeworld {

// Services on a callback queue and threads of their own, several at a time.
class ServiceQueue {
 public:
  explicit ServiceQueue(ros::NodeHandle node) : node_(std::move(node)) {
    node_.setCallbackQueue(&queue_);
  }
  ~ServiceQueue() { Stop(); }
  ServiceQueue(const ServiceQueue&) = delete;
  ServiceQueue& operator=(const ServiceQueue&) = delete;

  // The call succeeds whenever the handler returns: what went wrong stands in the response. Words
  // of an exception reach the caller, whose call fails.
  template <typename Service>
  void Advertise(
      const std::string& name,
      std::function<void(const typename Service::Request&, typename Service::Response*)> handler) {
    const boost::function<bool(typename Service::Request&, typename Service::Response&)> callback =
        [handler = std::move(handler)](typename Service::Request& request,
                                       typename Service::Response& response) {
          handler(request, &response);
          return true;
        };
    servers_.push_back(node_.advertiseService(name, callback));
  }

  // Returns the resolved names of all services.
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const ros::ServiceServer& server : servers_) names.push_back(server.getService());
    return names;
  }

  void Start() { spinner_.start(); }
  void Stop() {
    for (ros::ServiceServer& server : servers_) server.shutdown();
    spinner_.stop();
  }

 private:
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  std::vector<ros::ServiceServer> servers_;
  // One may be stepping for long, one saving, and the others shall still be answered.
  ros::AsyncSpinner spinner_{4, &queue_};
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NODE_SERVICE_QUEUE_H_
