#ifndef LATTICEWORLD_ROS_RUNNING_WORLD_LAUNCHER_H_
#define LATTICEWORLD_ROS_RUNNING_WORLD_LAUNCHER_H_

#include <cstdint>
#include <memory>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/status.h"
#include "latticeworld/generation/world.h"
#include "latticeworld_ros/publishing/map_publisher.h"
#include "latticeworld_ros/publishing/robot_topics.h"
#include "latticeworld_ros/running/simulation_loop.h"
#include "latticeworld_ros/server/world_server_options.h"

namespace latticeworld {

// Lets a complete world take the place of the running one: everything that takes time (maps, the
// simulator) is made before, on the caller's thread, while the old world goes on.
class WorldLauncher {
 public:
  // All of them outlive the launcher.
  WorldLauncher(const WorldServerOptions& options, SimulationLoop* loop, RobotTopics* robots,
                MapPublisher* maps);

  // One call at a time. stages: gets what was done and how long it took. When it fails, the old
  // world goes on as if nothing had been. Errors: CANCELLED, INVALID_ARGUMENT, UNAVAILABLE.
  Status Launch(std::shared_ptr<const World> world, const Progress& progress,
                std::vector<StageTime>* stages);

 private:
  const WorldServerOptions options_;
  SimulationLoop* const loop_;
  RobotTopics* const robots_;
  MapPublisher* const maps_;
  std::uint64_t last_run_ = 0;  // tells the simulations of this node apart
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_RUNNING_WORLD_LAUNCHER_H_
