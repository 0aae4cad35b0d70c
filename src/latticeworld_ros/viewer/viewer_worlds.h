#ifndef LATTICEWORLD_ROS_VIEWER_VIEWER_WORLDS_H_
#define LATTICEWORLD_ROS_VIEWER_VIEWER_WORLDS_H_

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/viewer/payloads/world_payloads.h"

namespace latticeworld {

// Fetches worlds of world_server and makes their payloads, on a thread of its own: the newest
// wanted, whatever is under way.
class ViewerWorlds {
 public:
  using OnWorld = std::function<void(std::shared_ptr<const WorldPayloads>)>;
  using OnProgress = std::function<void(const std::string& stage, double fraction)>;
  using OnFailure = std::function<void(const Status&)>;

  // All are called from the thread. A world that cannot be had is tried again after a second.
  ViewerWorlds(OnWorld on_world, OnProgress on_progress, OnFailure on_failure);
  ~ViewerWorlds() { Stop(); }
  ViewerWorlds(const ViewerWorlds&) = delete;
  ViewerWorlds& operator=(const ViewerWorlds&) = delete;

  // The world of that id is to be shown; "": none is wanted. Never waits.
  void Want(const std::string& world_id);
  // Ends once a call under way has ended, as it does when ROS shuts down.
  void Stop();

 private:
  void Run();
  Result<std::shared_ptr<const WorldPayloads>> Fetch(const Progress& progress) const;

  const OnWorld on_world_;
  const OnProgress on_progress_;
  const OnFailure on_failure_;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::string wanted_;             // guarded by mutex_, as what follows
  bool is_due_ = false;            // it is to be fetched
  Progress* under_way_ = nullptr;  // to be cancelled when another is wanted
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_VIEWER_VIEWER_WORLDS_H_
