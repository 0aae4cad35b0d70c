#ifndef LATTICEWORLD_PYTHON_CORE_ERRORS_H_
#define LATTICEWORLD_PYTHON_CORE_ERRORS_H_

#include <unistd.h>

#include <exception>
#include <string>
#include <utility>

#include "latticeworld/common/result.h"
#include "python.h"

namespace latticeworld::python {

// A failed Status on its way to Python, where latticeworld.errors makes an exception of it.
class StatusError : public std::exception {
 public:
  explicit StatusError(Status status) : status_(std::move(status)) {}
  const Status& status() const { return status_; }
  const char* what() const noexcept override { return status_.message().c_str(); }

 private:
  Status status_;
};

inline void Check(const Status& status) {
  if (!status.ok()) throw StatusError(status);
}
template <typename T>
T Value(Result<T> result) {
  Check(result.status());
  return std::move(result).value();
}

// What has threads of its own cannot be used on the other side of a fork: they stayed behind.
class ForkGuard {
 public:
  explicit ForkGuard(const char* what) : what_(what) {}
  bool forked() const { return getpid() != process_; }
  void Check() const {
    if (!forked()) return;
    throw StatusError(FailedPrecondition(
        std::string(what_) +
        " was made before this process was forked off, and its threads stayed "
        "behind; make it in the new process, or start processes by multiprocessing's \"spawn\""));
  }

 private:
  const char* what_;
  pid_t process_ = getpid();
};

// Runs without Python's lock, so that other threads of Python go on meanwhile.
template <typename Function>
auto WithoutLock(const Function& function) {
  nb::gil_scoped_release release;
  return function();
}

void BindErrors(nb::module_& module);

}  // namespace latticeworld::python

#endif  // LATTICEWORLD_PYTHON_CORE_ERRORS_H_
