#include "latticeworld/common/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "common/refused_threads.h"

namespace latticeworld {
namespace {

TEST(ParallelTest, VisitsEveryIndexOnce) {
  for (const int count : {1, 2, 3, 7, 64, 1000}) {
    for (const int threads : {0, 1, 2, 3, 7, 50}) {
      std::vector<std::atomic<int>> visits(count);
      ParallelFor(count, threads, [&](int begin, int end) {
        EXPECT_LT(begin, end);  // no empty part
        for (int i = begin; i < end; ++i) ++visits[i];
      });
      for (const auto& times : visits) EXPECT_EQ(times, 1) << count << " by " << threads;
    }
  }
}

TEST(ParallelTest, WhereNoMoreThreadsCanBeHadThoseThatThereAreDoAll) {
  for (const int left : {0, 1, 3}) {
    const RefusedThreads refused(left);
    std::vector<std::atomic<int>> visits(50);
    ParallelFor(50, 8, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) ++visits[i];
    });
    for (const auto& times : visits) EXPECT_EQ(times, 1) << left << " threads";
  }
}

TEST(ParallelTest, DoesNothingForNothing) {
  for (const int count : {0, -1}) {
    ParallelFor(count, 4, [](int, int) { FAIL() << "called for an empty range"; });
  }
}

TEST(ParallelTest, UsesAsManyThreadsAsAskedAndNotMore) {
  for (const int threads : {1, 2, 5}) {
    std::mutex mutex;
    std::set<std::thread::id> ids;
    ParallelFor(100, threads, [&](int, int) {
      const std::lock_guard<std::mutex> lock(mutex);
      ids.insert(std::this_thread::get_id());
    });
    EXPECT_LE(static_cast<int>(ids.size()), threads);
    EXPECT_EQ(ids.count(std::this_thread::get_id()), 1u);  // the caller works too
  }
}

TEST(ParallelTest, RunsItsPartsAtOnce) {
  // Each part waits for the other: one after the other they would never end.
  std::atomic<int> arrived{0};
  ParallelFor(2, 2, [&](int, int) {
    ++arrived;
    while (arrived < 2) std::this_thread::yield();
  });
  EXPECT_EQ(arrived, 2);
}

TEST(ParallelTest, NestsAndCountsLargeRanges) {
  std::atomic<std::int64_t> total{0};
  ParallelFor(2'000'000'000, 3, [&](int begin, int end) { total += end - begin; });
  EXPECT_EQ(total, 2'000'000'000);
  std::atomic<int> inner{0};
  ParallelFor(4, 2, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      ParallelFor(10, 3, [&](int b, int e) { inner += e - b; });
    }
  });
  EXPECT_EQ(inner, 40);
}

TEST(ParallelTest, PiecesAreTheSameWithAnyNumberOfThreads) {
  for (const int count : {1, 2, 7, 64, 1000}) {
    for (const int piece : {1, 3, 64, 5000}) {
      for (const int threads : {0, 1, 2, 5}) {
        std::vector<std::atomic<int>> visits(count);
        ParallelInPieces(count, piece, threads, [&](int begin, int end) {
          EXPECT_EQ(begin % piece, 0);
          EXPECT_EQ(end, std::min(count, begin + piece));
          for (int i = begin; i < end; ++i) ++visits[i];
        });
        for (const auto& times : visits) EXPECT_EQ(times, 1) << count << " by " << piece;
      }
    }
  }
  ParallelInPieces(0, 4, 2, [](int, int) { FAIL() << "called for an empty range"; });
  std::atomic<std::int64_t> total{0};
  ParallelInPieces(2'147'483'647, 1'000'000'000, 3,
                   [&](int begin, int end) { total += end - begin; });
  EXPECT_EQ(total, 2'147'483'647);
}

TEST(ParallelTest, WhoIsDoneTakesTheNextPiece) {
  // The first piece ends when all others are done: were they its thread's, they would never be.
  std::atomic<int> done{0};
  ParallelInPieces(8, 1, 2, [&](int begin, int) {
    if (begin == 0) {
      while (done < 7) std::this_thread::yield();
    }
    ++done;
  });
  EXPECT_EQ(done, 8);
}

}  // namespace
}  // namespace latticeworld
