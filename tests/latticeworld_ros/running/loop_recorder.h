#ifndef LATTICEWORLD_TESTS_ROS_RUNNING_LOOP_RECORDER_H_
#define LATTICEWORLD_TESTS_ROS_RUNNING_LOOP_RECORDER_H_

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <vector>

#include "latticeworld_ros/running/simulation_listener.h"

namespace latticeworld {

// Remembers every time that it is told, and lets a test wait for a count of them.
class LoopRecorder : public SimulationListener {
 public:
  void OnTick(const Tick& tick) override { Add(tick.now); }
  void OnStandstill(ros::Time now) override { Add(now); }
  void OnBegin() override {
    ++begins;
    MayThrow();
  }
  void OnRestore() override {
    ++restores;
    MayThrow();
  }
  void OnStatistics(const LoopStatistics& statistics) override {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      statistics_.push_back(statistics);
    }
    changed_.notify_all();
    MayThrow();
  }

  void WaitFor(std::size_t count) {
    std::unique_lock<std::mutex> lock(mutex_);
    ASSERT_TRUE(
        changed_.wait_for(lock, std::chrono::minutes(1), [&] { return times_.size() >= count; }));
  }
  std::vector<ros::Time> times() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return times_;
  }
  std::vector<LoopStatistics> statistics() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return statistics_;
  }

  std::atomic<int> begins{0};
  std::atomic<int> restores{0};
  std::atomic<bool> throws{false};  // after it has remembered

 private:
  void Add(ros::Time now) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      times_.push_back(now);
    }
    changed_.notify_all();
    MayThrow();
  }
  void MayThrow() {
    if (throws) throw std::runtime_error("nobody can hear this");
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<ros::Time> times_;
  std::vector<LoopStatistics> statistics_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_ROS_RUNNING_LOOP_RECORDER_H_
