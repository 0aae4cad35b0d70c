#ifndef LATTICEWORLD_ROS_NODE_STOPWATCH_H_
#define LATTICEWORLD_ROS_NODE_STOPWATCH_H_

#include <chrono>

namespace latticeworld {

// Wall time since it was made, on a clock that never jumps.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NODE_STOPWATCH_H_
