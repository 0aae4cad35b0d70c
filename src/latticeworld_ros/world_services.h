#ifndef LATTICEWORLD_ROS_WORLD_SERVICES_H_
#define LATTICEWORLD_ROS_WORLD_SERVICES_H_

#include <nav_msgs/GetMap.h>
#include <octomap_msgs/GetOctomap.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <filesystem>
#include <string>
#include <vector>

#include "latticeworld_ros/current_world.h"
#include "latticeworld_ros/messages.h"
#include "latticeworld_ros/robot_topics.h"
#include "latticeworld_ros/simulation_loop.h"

namespace latticeworld {

// The services about the world that runs and those on disk: everything but making a world. On a
// callback queue of their own, several at a time.
class WorldServices {
 public:
  // All of them outlive the services.
  WorldServices(ros::NodeHandle node, std::filesystem::path worlds_directory, SimulationLoop* loop,
                RobotTopics* robots, const CurrentWorld* current);
  ~WorldServices();

  void Start();
  void Stop();

 private:
  template <typename Service>
  using Handler = bool (WorldServices::*)(typename Service::Request&, typename Service::Response&);
  template <typename Service>
  void Advertise(const char* name, Handler<Service> handler);

  bool OnGet(latticeworld_msgs::GetWorld::Request&, latticeworld_msgs::GetWorld::Response&);
  bool OnSave(latticeworld_msgs::SaveWorld::Request&, latticeworld_msgs::SaveWorld::Response&);
  bool OnList(latticeworld_msgs::ListWorlds::Request&, latticeworld_msgs::ListWorlds::Response&);
  bool OnQuery(latticeworld_msgs::QueryTerrain::Request&,
               latticeworld_msgs::QueryTerrain::Response&);
  bool OnSpawn(latticeworld_msgs::SpawnAgent::Request&, latticeworld_msgs::SpawnAgent::Response&);
  bool OnRemove(latticeworld_msgs::RemoveAgent::Request&,
                latticeworld_msgs::RemoveAgent::Response&);
  bool OnSetWeather(latticeworld_msgs::SetWeather::Request&,
                    latticeworld_msgs::SetWeather::Response&);
  bool OnReset(latticeworld_msgs::ResetWorld::Request&, latticeworld_msgs::ResetWorld::Response&);
  bool OnStep(latticeworld_msgs::Step::Request&, latticeworld_msgs::Step::Response&);
  bool OnPause(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&);
  bool OnUnpause(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&);
  bool OnOctomapFull(octomap_msgs::GetOctomap::Request&, octomap_msgs::GetOctomap::Response&);
  bool OnOctomapBinary(octomap_msgs::GetOctomap::Request&, octomap_msgs::GetOctomap::Response&);
  bool OnStaticMap(nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response&);

  const std::filesystem::path worlds_directory_;
  SimulationLoop* const loop_;
  RobotTopics* const robots_;
  const CurrentWorld* const current_;

  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  std::vector<ros::ServiceServer> servers_;
  // One may be stepping for long, one saving, and the others shall still be answered.
  ros::AsyncSpinner spinner_{4, &queue_};
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_WORLD_SERVICES_H_
