#ifndef LATTICEWORLD_ROS_SERVER_CURRENT_WORLD_H_
#define LATTICEWORLD_ROS_SERVER_CURRENT_WORLD_H_

#include <memory>
#include <mutex>
#include <utility>

#include "latticeworld/generation/world.h"
#include "latticeworld_ros/publishing/world_messages.h"

namespace latticeworld {

// A world that runs and its maps. Immutable and shared.
struct PublishedWorld {
  std::shared_ptr<const World> world;
  WorldMessages messages;
  SceneChanges changes;  // that the maps show
};

// The world that runs now, for services to read while another one is made.
class CurrentWorld {
 public:
  std::shared_ptr<const PublishedWorld> Get() const {  // null: none yet
    const std::lock_guard<std::mutex> lock(mutex_);
    return world_;
  }
  void Set(std::shared_ptr<const PublishedWorld> world) {
    const std::lock_guard<std::mutex> lock(mutex_);
    world_.swap(world);
  }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const PublishedWorld> world_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_SERVER_CURRENT_WORLD_H_
