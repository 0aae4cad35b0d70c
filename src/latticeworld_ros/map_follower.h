#ifndef LATTICEWORLD_ROS_MAP_FOLLOWER_H_
#define LATTICEWORLD_ROS_MAP_FOLLOWER_H_

#include <ros/time.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "latticeworld/common/progress.h"
#include "latticeworld_ros/current_world.h"
#include "latticeworld_ros/map_publisher.h"
#include "latticeworld_ros/world_server_options.h"

namespace latticeworld {

// Lets the published maps follow what becomes of the trees: makes them anew on a thread of its own,
// at most every two seconds, always for the newest changes.
class MapFollower {
 public:
  // Both outlive the follower.
  MapFollower(const WorldServerOptions& options, const CurrentWorld* current, MapPublisher* maps);
  ~MapFollower();
  MapFollower(const MapFollower&) = delete;
  MapFollower& operator=(const MapFollower&) = delete;

  // What maps of that world should show, at that time. Does not block.
  void Follow(const std::string& world_id, SceneChanges changes, ros::Time now);
  void Stop();

 private:
  struct Wish {
    std::string world_id;
    SceneChanges changes;
    ros::Time now;
  };

  void Run();
  // False: the wish is of a world that is not published yet.
  bool Fulfil(const Wish& wish);

  const WorldServerOptions options_;
  const CurrentWorld* const current_;
  MapPublisher* const maps_;
  Progress progress_;  // cancelled by Stop

  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Wish> wish_;  // guarded by mutex_
  bool stopping_ = false;     // guarded by mutex_
  std::thread thread_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_MAP_FOLLOWER_H_
