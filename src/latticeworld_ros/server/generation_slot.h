#ifndef LATTICEWORLD_ROS_SERVER_GENERATION_SLOT_H_
#define LATTICEWORLD_ROS_SERVER_GENERATION_SLOT_H_

#include <memory>
#include <mutex>
#include <utility>

#include "latticeworld/common/progress.h"

namespace latticeworld {

// Lets one world at a time be made; a second request meanwhile is refused, not queued, so that
// nobody waits unknowingly for a world that another request replaces at once.
class GenerationSlot {
 public:
  // Holds the slot until it is destroyed.
  class Hold {
   public:
    Hold(GenerationSlot* slot, std::shared_ptr<Progress> progress)
        : slot_(slot), progress_(std::move(progress)) {}
    ~Hold() { slot_->Release(); }
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;
    const Progress& progress() const { return *progress_; }

   private:
    GenerationSlot* const slot_;
    const std::shared_ptr<Progress> progress_;
  };

  // Null: the slot is taken, or closed.
  std::unique_ptr<Hold> Take(Progress::Listener listener) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (closed_ || progress_ != nullptr) return nullptr;
    progress_ = std::make_shared<Progress>(std::move(listener));
    return std::make_unique<Hold>(this, progress_);
  }
  // Cancels what is being made, if anything is.
  void Cancel() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (progress_ != nullptr) progress_->Cancel();
  }
  // Cancels, and gives the slot to nobody any more.
  void Close() {
    const std::lock_guard<std::mutex> lock(mutex_);
    closed_ = true;
    if (progress_ != nullptr) progress_->Cancel();
  }

 private:
  void Release() {
    const std::lock_guard<std::mutex> lock(mutex_);
    progress_.reset();
  }

  std::mutex mutex_;
  std::shared_ptr<Progress> progress_;  // null: free
  bool closed_ = false;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_SERVER_GENERATION_SLOT_H_
