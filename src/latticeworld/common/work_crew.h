#ifndef LATTICEWORLD_COMMON_WORK_CREW_H_
#define LATTICEWORLD_COMMON_WORK_CREW_H_

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

namespace latticeworld {

// Threads that stay, for work whose pieces take microseconds: ParallelFor begins threads at each
// call, which takes longer. They wait awake for a moment after each call and then sleep. Whoever
// calls works too and never waits for a thread that has not begun, so that a busy machine costs
// speed alone. Results have to be the same whoever does which part.
class WorkCrew {
 public:
  // threads: with the one that calls; 0: as many as the machine has cores.
  explicit WorkCrew(int threads = 0);
  ~WorkCrew();
  WorkCrew(const WorkCrew&) = delete;
  WorkCrew& operator=(const WorkCrew&) = delete;

  int threads() const { return static_cast<int>(others_.size()) + 1; }
  int asleep() const { return asleep_; }  // of them, at the moment

  // Calls body(part) for each of [0, parts), several at once, and returns when all are done. parts:
  // at most 65,535. body must not throw and not call Run. One thread at a time may call.
  template <typename Body>
  void Run(int parts, const Body& body) {
    Run(
        parts, [](const void* of, int part) { (*static_cast<const Body*>(of))(part); }, &body);
  }

 private:
  using Function = void (*)(const void* body, int part);

  void Run(int parts, Function function, const void* body);
  bool TakePart();  // does one part; false: there is none left
  void Help();      // what the others do until the end

  // The number of the call in the high 32 bits, how many parts it has in the next 16, and the first
  // that nobody has taken yet: one word, so that no part of an ended call can be taken.
  std::atomic<std::uint64_t> ticket_{0};
  std::atomic<int> done_{0};  // parts of the call
  Function function_ = nullptr;
  const void* body_ = nullptr;

  std::mutex mutex_;  // for going to sleep
  std::condition_variable called_;
  std::atomic<int> asleep_{0};
  std::atomic<bool> ended_{false};
  std::vector<std::thread> others_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_COMMON_WORK_CREW_H_
