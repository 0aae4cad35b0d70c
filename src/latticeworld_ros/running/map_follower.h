#ifndef LATTICEWORLD_ROS_RUNNING_MAP_FOLLOWER_H_
#define LATTICEWORLD_ROS_RUNNING_MAP_FOLLOWER_H_

#include <ros/time.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "latticeworld/common/progress.h"
#include "latticeworld_ros/publishing/map_publisher.h"
#include "latticeworld_ros/server/current_world.h"
#include "latticeworld_ros/server/world_server_options.h"

namespace latticeworld {

// What the maps of a world should show.
struct MapWish {
  std::weak_ptr<const World> world;  // the object: worlds of one bundle have one id
  SceneChanges changes;
  ros::Time now;
};
enum class WishStanding {
  kWaits,  // another world is published, and this one lives: it will be
  kOpen,   // the published maps of this world show something else
  kDone,   // they show it, or the world is gone
};
// published: null: no world yet.
WishStanding StandingOf(const MapWish& wish, const PublishedWorld* published);

// Lets the published maps follow what becomes of the trees: makes them anew on a thread of its own
// that steps back behind the simulation's, at most every two seconds, always for the newest
// changes.
class MapFollower {
 public:
  // `current` and `maps` must outlive this.
  MapFollower(const WorldServerOptions& options, const CurrentWorld* current, MapPublisher* maps);
  ~MapFollower();
  MapFollower(const MapFollower&) = delete;
  MapFollower& operator=(const MapFollower&) = delete;

  // What maps of that world should show, at that time. Does not block.
  void Follow(const std::shared_ptr<const World>& world, SceneChanges changes, ros::Time now);
  void Stop();

 private:
  void Run();
  // False: the wish has to wait.
  bool Fulfil(const MapWish& wish);

  const WorldServerOptions options_;
  const CurrentWorld* const current_;
  MapPublisher* const maps_;
  Progress progress_;  // cancelled by Stop

  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<MapWish> wish_;  // guarded by mutex_
  bool stopping_ = false;        // guarded by mutex_
  std::thread thread_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_RUNNING_MAP_FOLLOWER_H_
