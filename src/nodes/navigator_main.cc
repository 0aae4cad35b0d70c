// The reference navigator: drives a robot to goals of the action move_base.
// Parameters: launch_cfg/navigator.yaml. Topics and services: docs/navigation.md.

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <memory>
#include <utility>

#include "latticeworld_ros/navigator/navigator_node.h"
#include "latticeworld_ros/navigator/navigator_node_options.h"
#include "latticeworld_ros/node/master_watch.h"
#include "latticeworld_ros/node/node_start.h"

int main(int argc, char** argv) {
  // The robot is told to stand before ROS ends: what this handler asks for is done by main.
  static volatile std::sig_atomic_t asked_to_end = 0;
  ros::init(argc, argv, "navigator", ros::init_options::NoSigintHandler);
  for (const int signal : {SIGINT, SIGTERM}) {
    std::signal(signal, [](int) { asked_to_end = 1; });
  }
  latticeworld::PrepareNode();
  XmlRpc::XmlRpcValue parameters;
  (void)ros::param::get(ros::this_node::getName(), parameters);  // none at all is legal
  const auto options = latticeworld::NavigatorOptionsFromParameters(parameters);
  if (!options.ok()) {
    ROS_FATAL_STREAM(options.status().ToString());
    return EXIT_FAILURE;
  }
  try {
    auto navigator = latticeworld::NavigatorNode::Create(ros::NodeHandle(), *options);
    if (!navigator.ok()) {
      ROS_FATAL_STREAM(navigator.status().ToString());
      return EXIT_FAILURE;
    }
    ROS_INFO_STREAM("ready: goals of " << options->robot << " go to "
                                       << ros::names::resolve(options->robot + "/move_base"));
    latticeworld::MasterWatch master;
    master.Start({});
    while (asked_to_end == 0 && ros::ok()) {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
    }
    master.Stop();
    navigator->reset();
    ros::shutdown();
  } catch (const std::exception& error) {
    ROS_FATAL_STREAM("navigator: " << error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
