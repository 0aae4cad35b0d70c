#include "tools/interrupt.h"

#include <atomic>

#include "latticeworld/common/check.h"

namespace latticeworld::tools {
namespace {

// A signal handler is given nothing, so this one pointer has to be where it can see it.
std::atomic<Progress*> cancelled_by_signals{nullptr};
static_assert(std::atomic<Progress*>::is_always_lock_free, "used in a signal handler");

void HandleSignal(int) {
  if (Progress* progress = cancelled_by_signals.load()) progress->Cancel();
}

}  // namespace

CancelOnInterrupt::CancelOnInterrupt(Progress* progress) {
  LW_CHECK(cancelled_by_signals.exchange(progress) == nullptr, "one CancelOnInterrupt at a time");
  struct sigaction action = {};
  action.sa_handler = HandleSignal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, &previous_interrupt_);
  sigaction(SIGTERM, &action, &previous_terminate_);
}

CancelOnInterrupt::~CancelOnInterrupt() {
  sigaction(SIGINT, &previous_interrupt_, nullptr);
  sigaction(SIGTERM, &previous_terminate_, nullptr);
  cancelled_by_signals.store(nullptr);
}

}  // namespace latticeworld::tools
