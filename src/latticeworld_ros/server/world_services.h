#ifndef LATTICEWORLD_ROS_SERVER_WORLD_SERVICES_H_
#define LATTICEWORLD_ROS_SERVER_WORLD_SERVICES_H_

#include <filesystem>

#include "latticeworld/mapping/traversability.h"
#include "latticeworld_ros/node/service_queue.h"
#include "latticeworld_ros/running/simulation_loop.h"
#include "latticeworld_ros/server/current_world.h"

namespace latticeworld {

// The world that runs and those on disk, all but making one: get_world, save_world, list_worlds,
// query_terrain, set_weather, octomap_full, octomap_binary, static_map. map_values: of bundles
// that are saved. loop and current outlive the queue's services.
void AdvertiseWorldServices(const std::filesystem::path& worlds_directory, MapValues map_values,
                            SimulationLoop* loop, const CurrentWorld* current, ServiceQueue* queue);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_SERVER_WORLD_SERVICES_H_
