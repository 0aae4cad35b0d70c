#ifndef LATTICEWORLD_ROS_NODE_MASTER_WATCH_H_
#define LATTICEWORLD_ROS_NODE_MASTER_WATCH_H_

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "latticeworld_ros/node/descriptors.h"
#include "latticeworld_ros/node/master_state.h"

namespace latticeworld {

// What this node knows of itself at the master and of its connections.
struct MasterReport {
  DescriptorUse descriptors;
  std::size_t topics = 0;                        // of this node
  std::vector<std::string> not_delivered;        // topics, while descriptors are short
  std::vector<ServiceStanding::Taken> services;  // of this node that callers find elsewhere
};

// Asks the master every few seconds, on a thread of its own, for that takes milliseconds and more,
// what became of this node's services and topics. A service that another node has taken and then
// given up, or that it has no more because it was killed, is announced again; while the other one
// has it, it stays there. A master that was started anew knows nobody: services and topics are
// announced again, what this node listens to only at the next look, once others have announced what
// they publish, for roscpp ends connections to publishers that the master does not name.
class MasterWatch {
 public:
  MasterWatch() = default;
  ~MasterWatch();
  MasterWatch(const MasterWatch&) = delete;
  MasterWatch& operator=(const MasterWatch&) = delete;

  // services: that this node offers, with their whole names.
  void Start(std::vector<std::string> services);
  // Is to be called before the services end.
  void Stop();
  MasterReport report() const;

 private:
  void Run();
  void Look();
  void AnnounceTopics(UnknownTopics unknown);
  void WarnOfTaken(const std::vector<ServiceStanding::Taken>& taken);

  std::vector<std::string> services_;
  // Only the thread touches these.
  std::vector<std::string> told_;     // taken services of which a warning was written
  std::vector<std::string> unsure_;   // topics not delivered at the last look
  std::vector<std::string> unheard_;  // subscribed topics that the master did not know then
  bool short_told_ = false;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool stopping_ = false;  // guarded by mutex_
  MasterReport report_;    // guarded by mutex_
  std::thread thread_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NODE_MASTER_WATCH_H_
