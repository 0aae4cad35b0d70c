#include "latticeworld_ros/running/world_launcher.h"

#include <ros/console.h>

#include <string>
#include <utility>

#include "latticeworld/simulation/journaled_simulator.h"
#include "latticeworld/simulation/start_warnings.h"
#include "latticeworld_ros/node/stopwatch.h"

namespace latticeworld {

WorldLauncher::WorldLauncher(const WorldServerOptions& options, SimulationLoop* loop,
                             RobotTopics* robots, MapPublisher* maps)
    : options_(options), loop_(loop), robots_(robots), maps_(maps) {}

Status WorldLauncher::Launch(std::shared_ptr<const World> world, const Progress& progress,
                             std::vector<StageTime>* stages) {
  LW_ASSIGN_OR_RETURN(WorldMessages messages,
                      BuildWorldMessages(*world, options_, progress, stages));
  const Stopwatch simulator_watch;
  LaunchedWorld running;
  running.world = world;
  LW_ASSIGN_OR_RETURN(std::unique_ptr<Simulator> simulator,
                      Simulator::Create(world->scene, options_.simulator, world->request.seed));
  for (const std::string& warning :
       StartWarnings(*world->scene, *simulator->State(), *options_.simulator.species)) {
    ROS_WARN_STREAM(warning);
  }
  running.simulator = std::make_unique<JournaledSimulator>(std::move(simulator), ++last_run_);
  stages->push_back({"simulator", simulator_watch.seconds()});

  // The last moment at which a cancel leaves the old world running.
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  const Stopwatch swap_watch;
  LW_ASSIGN_OR_RETURN(const ros::Time stamp, loop_->Swap(&running));
  SetStamp(stamp, &messages);
  auto published = std::make_shared<PublishedWorld>();
  published->world = std::move(world);
  published->messages = std::move(messages);
  maps_->Publish(std::move(published));
  robots_->WaitUntilReady();
  stages->push_back({"swap", swap_watch.seconds()});
  return Status();
}

}  // namespace latticeworld
