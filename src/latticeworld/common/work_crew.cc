#include "latticeworld/common/work_crew.h"

#include <algorithm>
#include <system_error>

#include "latticeworld/common/check.h"

namespace latticeworld {
namespace {

constexpr std::uint64_t kMostParts = 0xFFFF;
constexpr int kLooks = 4000;  // for work before going to sleep: some tens of microseconds

void Breathe() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

std::uint64_t PartsOf(std::uint64_t ticket) { return ticket >> 16 & kMostParts; }
std::uint64_t NextOf(std::uint64_t ticket) { return ticket & kMostParts; }
bool HasWork(std::uint64_t ticket) { return NextOf(ticket) < PartsOf(ticket); }

}  // namespace

WorkCrew::WorkCrew(int threads) {
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const int wanted = threads > 0 ? threads : cores;
  try {
    for (int i = 1; i < wanted; ++i) others_.emplace_back([this] { Help(); });
  } catch (const std::system_error&) {  // no more threads can be had: those that there are do all
  }
}

WorkCrew::~WorkCrew() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ended_ = true;
  }
  called_.notify_all();
  for (std::thread& other : others_) other.join();
}

bool WorkCrew::TakePart() {
  std::uint64_t ticket = ticket_.load(std::memory_order_acquire);
  while (HasWork(ticket)) {
    if (!ticket_.compare_exchange_weak(ticket, ticket + 1, std::memory_order_acq_rel)) continue;
    // The call cannot end before this part is done, so that what it calls stays as it is.
    function_(body_, static_cast<int>(NextOf(ticket)));
    done_.fetch_add(1, std::memory_order_release);
    return true;
  }
  return false;
}

void WorkCrew::Run(int parts, Function function, const void* body) {
  LW_CHECK(parts >= 0 && static_cast<std::uint64_t>(parts) <= kMostParts,
           "a call has at most 65,535 parts");
  if (parts == 1 || others_.empty()) {
    for (int part = 0; part < parts; ++part) function(body, part);
    return;
  }
  function_ = function;
  body_ = body;
  done_.store(0, std::memory_order_relaxed);
  const std::uint64_t call = (ticket_.load(std::memory_order_relaxed) >> 32) + 1;
  // The ticket is stored before asleep_ is read, in one order with it. A thread that falls asleep
  // says so before it looks for work, so that either it sees the ticket or it is woken here.
  ticket_.store(call << 32 | static_cast<std::uint64_t>(parts) << 16, std::memory_order_seq_cst);
  if (asleep_.load(std::memory_order_seq_cst) > 0) {
    { const std::lock_guard<std::mutex> lock(mutex_); }
    called_.notify_all();
  }
  while (TakePart()) {
  }
  for (int looks = 0; done_.load(std::memory_order_acquire) < parts; ++looks) {
    if (looks < kLooks) {
      Breathe();
    } else {
      std::this_thread::yield();
    }
  }
}

void WorkCrew::Help() {
  int looks = 0;
  while (!ended_.load(std::memory_order_relaxed)) {
    if (TakePart()) {
      looks = 0;
    } else if (++looks < kLooks) {
      Breathe();
    } else {
      std::unique_lock<std::mutex> lock(mutex_);
      asleep_.fetch_add(1, std::memory_order_seq_cst);
      called_.wait(lock, [this] {
        return ended_.load(std::memory_order_relaxed) ||
               HasWork(ticket_.load(std::memory_order_seq_cst));
      });
      asleep_.fetch_sub(1, std::memory_order_relaxed);
      looks = 0;
    }
  }
}

}  // namespace latticeworld
