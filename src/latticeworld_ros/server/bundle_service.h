#ifndef LATTICEWORLD_ROS_SERVER_BUNDLE_SERVICE_H_
#define LATTICEWORLD_ROS_SERVER_BUNDLE_SERVICE_H_

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/episode/world_files.h"
#include "latticeworld_ros/conversion/messages.h"
#include "latticeworld_ros/node/service_queue.h"
#include "latticeworld_ros/running/simulation_loop.h"

namespace latticeworld {

// get_world_bundle: all that the running simulation comes of, for who records episodes.
class BundleService {
 public:
  // loop: outlives the queue. A world whose files have most_message_bytes or more is refused
  // (RESOURCE_EXHAUSTED).
  BundleService(SimulationLoop* loop, std::uint64_t most_message_bytes, ServiceQueue* queue);

 private:
  Status Answer(const latticeworld_msgs::GetWorldBundle::Request& request,
                latticeworld_msgs::GetWorldBundle::Response* response);
  // Those of the last world that was asked for are kept. Errors: as PackWorld.
  Result<std::shared_ptr<const std::vector<WorldFile>>> FilesOf(
      const std::shared_ptr<const World>& world);

  SimulationLoop* const loop_;
  const std::uint64_t most_message_bytes_;
  std::mutex mutex_;
  // Guarded by mutex_; the files of a world that nobody runs any more are let go with it only when
  // another one is packed.
  std::weak_ptr<const World> packed_world_;
  std::shared_ptr<const std::vector<WorldFile>> packed_files_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_SERVER_BUNDLE_SERVICE_H_
