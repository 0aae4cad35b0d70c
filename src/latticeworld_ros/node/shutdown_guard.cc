#include "latticeworld_ros/node/shutdown_guard.h"

#include <cstdlib>

namespace latticeworld {

ShutdownGuard::ShutdownGuard(std::chrono::milliseconds patience)
    : thread_([this, patience] {
        std::unique_lock<std::mutex> lock(mutex_);
        if (!changed_.wait_for(lock, patience, [this] { return done_; })) {
          std::_Exit(EXIT_SUCCESS);
        }
      }) {}

ShutdownGuard::~ShutdownGuard() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    done_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

}  // namespace latticeworld
