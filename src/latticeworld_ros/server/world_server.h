#ifndef LATTICEWORLD_ROS_SERVER_WORLD_SERVER_H_
#define LATTICEWORLD_ROS_SERVER_WORLD_SERVER_H_

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <memory>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/generation/bundle/load_language.h"
#include "latticeworld/generation/sketch_translator.h"
#include "latticeworld_ros/node/master_watch.h"
#include "latticeworld_ros/node/service_queue.h"
#include "latticeworld_ros/publishing/map_publisher.h"
#include "latticeworld_ros/publishing/robot_topics.h"
#include "latticeworld_ros/publishing/sensor_topics.h"
#include "latticeworld_ros/publishing/state_publisher.h"
#include "latticeworld_ros/running/map_follower.h"
#include "latticeworld_ros/running/sensor_thread.h"
#include "latticeworld_ros/running/simulation_loop.h"
#include "latticeworld_ros/running/world_launcher.h"
#include "latticeworld_ros/server/bundle_service.h"
#include "latticeworld_ros/server/current_world.h"
#include "latticeworld_ros/server/generation_service.h"
#include "latticeworld_ros/server/world_server_options.h"

namespace latticeworld {

// The node: its parts and how they hang together.
//
//   simulation loop (1 thread)   steps, owns time, tells the state publisher
//   generation (2)               generate_world, generate_world_action, load_world
//   services (4)                 everything else that is asked for
//   commands (1)                 what is commanded to every robot
//   robot topics (1)             makes and ends the topics of robots
//   sensors (1)                  makes and publishes what robots sense
//   map follower (1)             makes maps anew when trees have fallen
//   master watch (1)             looks after services and topics at the master
class WorldServer {
 public:
  // options: valid. sketches: what options.sketch_model names. catalogue: what options.catalogue
  // adds to; not null.
  WorldServer(ros::NodeHandle node, const WorldServerOptions& options, LoadedLanguage language,
              SketchTranslator sketches, std::shared_ptr<const Catalogue> catalogue);
  ~WorldServer();

 private:
  ros::CallbackQueue command_queue_;
  CurrentWorld current_;
  MapPublisher maps_;
  MapFollower follower_;
  SensorTopics sensor_topics_;
  SensorThread sensors_;
  RobotTopics robots_;
  MasterWatch master_;
  StatePublisher states_;
  SimulationLoop loop_;
  WorldLauncher launcher_;
  GenerationService generation_;
  ServiceQueue services_;
  BundleService bundles_;
  ros::AsyncSpinner command_spinner_{1, &command_queue_};
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_SERVER_WORLD_SERVER_H_
