#ifndef LATTICEWORLD_COMMON_PROGRESS_H_
#define LATTICEWORLD_COMMON_PROGRESS_H_

#include <atomic>
#include <functional>
#include <string_view>

#include "latticeworld/common/status.h"

namespace latticeworld {

// How a long computation reports where it is and learns that nobody wants its answer any more.
// Report and CheckCancelled are called from the computing thread, Cancel from any thread.
class Progress {
 public:
  // stage: its name ("layout", "terrain", ...); fraction: of that stage, in [0, 1].
  using Listener = std::function<void(std::string_view stage, double fraction)>;

  Progress() = default;
  explicit Progress(Listener listener) : listener_(std::move(listener)) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void Report(std::string_view stage, double fraction) const {
    if (listener_) listener_(stage, fraction);
  }
  void Cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
  // CANCELLED once Cancel was called, else OK.
  Status CheckCancelled() const {
    return cancelled() ? Cancelled("cancelled by the caller") : Status();
  }

 private:
  Listener listener_;
  std::atomic<bool> cancelled_{false};
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_COMMON_PROGRESS_H_
