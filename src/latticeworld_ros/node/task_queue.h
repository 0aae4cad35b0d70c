#ifndef LATTICEWORLD_ROS_NODE_TASK_QUEUE_H_
#define LATTICEWORLD_ROS_NODE_TASK_QUEUE_H_

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <utility>

#include "latticeworld/common/result.h"
#include "latticeworld_ros/node/guarded.h"
#include "latticeworld_ros/running/loop_clock.h"

namespace latticeworld {

// What other threads ask of the one thread that owns something, which runs it when it has time.
class TaskQueue {
 public:
  // clock: outlives the queue. stopped: what callers hear once the queue is stopped.
  TaskQueue(LoopClock* clock, Status stopped) : clock_(clock), stopped_(std::move(stopped)) {}

  // The task throws nothing. False: the queue is stopped, the task will not run.
  bool Post(std::function<void()> task) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (stopping_) return false;
      tasks_.push_back(std::move(task));
    }
    wake_.notify_all();
    return true;
  }

  // Posts what starts the work; waits for its answer, which may come long after `start` returned.
  // An exception of `start` is the caller's (INTERNAL); the owner goes on.
  template <typename T>
  Result<T> CallLater(std::function<void(std::shared_ptr<std::promise<Result<T>>>)> start) {
    // The promise is shared, for the task may outlive this call's stack when the queue stops.
    auto promise = std::make_shared<std::promise<Result<T>>>();
    std::future<Result<T>> answer = promise->get_future();
    // Nothing but the queue may keep the promise while this call waits, else Drop cannot break it.
    const bool posted = Post([promise, start = std::move(start)] {
      const auto words = ExceptionOf([&] { start(promise); });
      if (!words.has_value()) return;
      // An answer that was given already stays.
      (void)ExceptionOf([&] { promise->set_value(Internal(*words)); });
    });
    promise.reset();
    if (!posted) return stopped_;
    try {
      return answer.get();
    } catch (const std::future_error&) {  // dropped
      return stopped_;
    }
  }

  // Posts the task and waits for its answer. An exception of it is the caller's (INTERNAL).
  template <typename T>
  Result<T> Call(std::function<Result<T>()> task) {
    return CallLater<T>([task = std::move(task)](std::shared_ptr<std::promise<Result<T>>> promise) {
      promise->set_value(task());
    });
  }

  // The owner waits until `due`, which tasks may change, and runs tasks meanwhile. hurried: asked
  // after tasks, true: does not wait any longer. Time goes on even for those who ask without end.
  // False: the queue is stopped.
  bool WaitUntil(LoopClock::TimePoint due, const std::function<bool()>& hurried) {
    for (;;) {
      std::deque<std::function<void()>> tasks;
      {
        std::unique_lock<std::mutex> lock(mutex_);
        clock_->Wait(&wake_, &lock, due, [this] { return stopping_ || !tasks_.empty(); });
        if (stopping_) return false;
        if (tasks_.empty()) return true;
        tasks.swap(tasks_);
      }
      for (const std::function<void()>& task : tasks) task();
      if (hurried() || clock_->Now() >= due) return true;
    }
  }

  void Stop() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      stopping_ = true;
    }
    wake_.notify_all();
  }

  // The owner calls this after Stop: whoever waits for a task hears, by its broken promise, that
  // none will come.
  void Drop() {
    std::deque<std::function<void()>> dropped;
    const std::lock_guard<std::mutex> lock(mutex_);
    dropped.swap(tasks_);
  }

 private:
  LoopClock* const clock_;
  const Status stopped_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<std::function<void()>> tasks_;  // guarded by mutex_
  bool stopping_ = false;                    // guarded by mutex_
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NODE_TASK_QUEUE_H_
