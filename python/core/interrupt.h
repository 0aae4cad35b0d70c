#ifndef LATTICEWORLD_PYTHON_CORE_INTERRUPT_H_
#define LATTICEWORLD_PYTHON_CORE_INTERRUPT_H_

#include <exception>
#include <string_view>

#include "latticeworld/common/progress.h"
#include "python.h"

namespace latticeworld::python {

// Lets Ctrl-C, and whoever listens, end a computation that runs without Python's lock.
class [[gnu::visibility("hidden")]] Interruptible {
 public:
  // listener: called with (stage, fraction); may be None. What it raises ends the computation.
  explicit Interruptible(nb::object listener)
      : listener_(std::move(listener)),
        progress_([this](std::string_view stage, double fraction) { OnReport(stage, fraction); }) {}

  const Progress& progress() const { return progress_; }
  // Throws what ended it, if anything did. With Python's lock.
  void Check() const {
    if (raised_ != nullptr) std::rethrow_exception(raised_);
  }

 private:
  void OnReport(std::string_view stage, double fraction) {
    if (raised_ != nullptr) return;
    const nb::gil_scoped_acquire lock;
    try {
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
      if (!listener_.is_none()) listener_(nb::str(stage.data(), stage.size()), fraction);
    } catch (...) {
      raised_ = std::current_exception();
      progress_.Cancel();
    }
  }

  nb::object listener_;
  std::exception_ptr raised_;
  Progress progress_;
};

}  // namespace latticeworld::python

#endif  // LATTICEWORLD_PYTHON_CORE_INTERRUPT_H_
