// The episode recorder: start_episode writes what a world_server does into a rosbag.
// Parameters: launch_cfg/episode_recorder.yaml. Services and topics: docs/episodes.md.

#include <ros/ros.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "latticeworld_ros/episode/episode_recorder.h"
#include "latticeworld_ros/episode/episode_recorder_options.h"
#include "latticeworld_ros/node/master_watch.h"
#include "latticeworld_ros/node/node_start.h"

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow fails to be written, no more
  // Bags are closed before ROS is: what this handler asks for is done by main.
  static volatile std::sig_atomic_t asked_to_end = 0;
  ros::init(argc, argv, "episode_recorder", ros::init_options::NoSigintHandler);
  for (const int signal : {SIGINT, SIGTERM}) {
    std::signal(signal, [](int) { asked_to_end = 1; });
  }
  latticeworld::PrepareNode();
  XmlRpc::XmlRpcValue parameters;
  (void)ros::param::get(ros::this_node::getName(), parameters);  // none at all is legal
  const auto options = latticeworld::RecorderOptionsFromParameters(parameters);
  if (!options.ok()) {
    ROS_FATAL_STREAM(options.status().ToString());
    return EXIT_FAILURE;
  }
  try {
    ros::NodeHandle node;
    auto recorder = std::make_unique<latticeworld::EpisodeRecorder>(node, *options);
    // For what roscpp itself asks: the clock, and the status that is latched.
    ros::AsyncSpinner spinner(1);
    spinner.start();
    latticeworld::MasterWatch master;
    std::vector<std::string> services;
    for (const char* name : {"start_episode", "stop_episode", "list_episodes"}) {
      services.push_back(node.resolveName(name));
    }
    master.Start(std::move(services));
    ROS_INFO("ready: call start_episode");
    while (asked_to_end == 0 && ros::ok()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    master.Stop();
    recorder.reset();
    ros::shutdown();
  } catch (const std::exception& error) {
    ROS_FATAL_STREAM("episode_recorder: " << error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
