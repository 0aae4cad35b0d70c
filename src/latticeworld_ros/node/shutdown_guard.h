#ifndef LATTICEWORLD_ROS_NODE_SHUTDOWN_GUARD_H_
#define LATTICEWORLD_ROS_NODE_SHUTDOWN_GUARD_H_

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace latticeworld {

// Ends the process with success when what follows in this scope takes longer than `patience`. The
// stages of a very large world may hear a cancel only after seconds, and a master that hangs never
// answers; nobody who presses Ctrl-C waits for that. Nothing is lost, for files are written whole
// or not at all.
class ShutdownGuard {
 public:
  explicit ShutdownGuard(std::chrono::milliseconds patience);
  ~ShutdownGuard();
  ShutdownGuard(const ShutdownGuard&) = delete;
  ShutdownGuard& operator=(const ShutdownGuard&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool done_ = false;
  std::thread thread_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NODE_SHUTDOWN_GUARD_H_
