#include "latticeworld/common/work_crew.h"

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <numeric>
#include <set>
#include <thread>
#include <vector>

#include "common/refused_threads.h"

namespace latticeworld {
namespace {

TEST(WorkCrewTest, DoesEveryPartOnceAtEveryCall) {
  for (const int threads : {1, 2, 3, 8}) {
    WorkCrew crew(threads);
    EXPECT_EQ(crew.threads(), threads);
    for (const int parts : {0, 1, 2, 5, 100, 65535}) {
      std::vector<std::atomic<int>> times(static_cast<std::size_t>(parts));
      crew.Run(parts, [&](int part) { ++times[static_cast<std::size_t>(part)]; });
      for (const auto& each : times) ASSERT_EQ(each, 1) << parts << " by " << threads;
    }
  }
}

TEST(WorkCrewTest, WhereNoMoreThreadsCanBeHadThoseThatThereAreDoAll) {
  for (const int left : {0, 1}) {
    const RefusedThreads refused(left);
    WorkCrew crew(4);
    EXPECT_EQ(crew.threads(), left + 1);
    std::vector<std::atomic<int>> times(100);
    crew.Run(100, [&](int part) { ++times[static_cast<std::size_t>(part)]; });
    for (const auto& each : times) ASSERT_EQ(each, 1);
  }
}

// What a call has written is there for the next one, however fast they follow each other and
// whether the others are awake or have gone to sleep.
TEST(WorkCrewTest, CallsFollowEachOther) {
  constexpr int kParts = 7, kCalls = 20000;
  WorkCrew crew(3);
  std::vector<std::int64_t> values(kParts, 1), next(kParts);
  std::int64_t expected = kParts;
  for (int call = 0; call < kCalls; ++call) {
    const std::int64_t sum = std::accumulate(values.begin(), values.end(), std::int64_t{0});
    ASSERT_EQ(sum, expected);
    crew.Run(kParts, [&](int part) { next[part] = (sum + part * call) % 1000003; });
    values.swap(next);
    expected = 0;
    for (int part = 0; part < kParts; ++part) expected += (sum + part * call) % 1000003;
  }
}

// Parts that wait for each other end only if each thread of a crew of three has one.
std::set<std::thread::id> Meeting(WorkCrew* crew) {
  std::mutex mutex;
  std::condition_variable all_there;
  std::set<std::thread::id> there;
  crew->Run(3, [&](int) {
    std::unique_lock<std::mutex> lock(mutex);
    there.insert(std::this_thread::get_id());
    all_there.notify_all();
    all_there.wait(lock, [&] { return there.size() == 3; });
  });
  return there;
}

TEST(WorkCrewTest, SeveralThreadsWorkAtOnceAwakeOrAsleep) {
  WorkCrew crew(3);
  for (int call = 0; call < 3; ++call) {
    EXPECT_EQ(Meeting(&crew).count(std::this_thread::get_id()), 1u) << "who calls works too";
    while (crew.asleep() < 2) std::this_thread::yield();
  }
}

TEST(WorkCrewTest, ReturnsWhenTheSlowestIsDone) {
  WorkCrew crew(2);
  const std::thread::id caller = std::this_thread::get_id();
  for (int call = 0; call < 20; ++call) {
    std::atomic<int> begun{0};
    std::atomic<std::uint64_t> made{0};
    crew.Run(2, [&](int) {
      ++begun;
      while (begun < 2) std::this_thread::yield();  // each thread has a part
      if (std::this_thread::get_id() == caller) return;
      std::uint64_t value = 1;
      for (int i = 0; i < 1000000; ++i) value = value * 6364136223846793005u + 1442695040888963407u;
      made = value | 1u;
    });
    ASSERT_NE(made, 0u);
  }
}

TEST(WorkCrewTest, HasAThreadForEachCoreUnlessTold) {
  EXPECT_EQ(WorkCrew().threads(), static_cast<int>(std::thread::hardware_concurrency()));
  EXPECT_EQ(WorkCrew(1).threads(), 1);
}

}  // namespace
}  // namespace latticeworld
