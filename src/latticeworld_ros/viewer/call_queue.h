#ifndef LATTICEWORLD_ROS_VIEWER_CALL_QUEUE_H_
#define LATTICEWORLD_ROS_VIEWER_CALL_QUEUE_H_

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace latticeworld {

// Runs calls in their order on threads of its own.
class CallQueue {
 public:
  CallQueue(std::size_t threads, std::size_t most_waiting);
  ~CallQueue() { Stop(); }
  // False: too many wait already, or it has stopped.
  bool Add(std::function<void()> call);
  // What waits is dropped; waits for what runs.
  void Stop();

 private:
  void Run();

  const std::size_t most_waiting_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> waiting_;
  bool stop_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_VIEWER_CALL_QUEUE_H_
