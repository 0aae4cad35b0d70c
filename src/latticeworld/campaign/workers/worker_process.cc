#include "latticeworld/campaign/workers/worker_process.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace latticeworld {
namespace {

void Close(int* descriptor) {
  if (*descriptor >= 0) ::close(*descriptor);
  *descriptor = -1;
}

}  // namespace

Result<WorkerProcess> WorkerProcess::Start(const std::vector<std::string>& command) {
  LW_ASSIGN_OR_RETURN(const ChildProcess child, StartChild(command));
  return WorkerProcess(child.pid, child.in, child.out);
}

WorkerProcess::WorkerProcess(WorkerProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, 0)),
      in_(std::exchange(other.in_, -1)),
      out_(std::exchange(other.out_, -1)),
      unread_(std::move(other.unread_)),
      trial_(other.trial_),
      since_(other.since_) {}

WorkerProcess& WorkerProcess::operator=(WorkerProcess&& other) noexcept {
  if (this == &other) return *this;
  End();
  pid_ = std::exchange(other.pid_, 0);
  in_ = std::exchange(other.in_, -1);
  out_ = std::exchange(other.out_, -1);
  unread_ = std::move(other.unread_);
  trial_ = other.trial_;
  since_ = other.since_;
  return *this;
}

WorkerProcess::~WorkerProcess() { End(); }

bool WorkerProcess::Give(std::size_t index) {
  trial_ = index;
  since_ = std::chrono::steady_clock::now();
  const std::string line = std::to_string(index) + "\n";
  // A worker that is gone is no reason to end.
  return WriteQuietly(in_, line.data(), line.size()) == static_cast<ssize_t>(line.size());
}

bool WorkerProcess::Read(std::vector<std::string>* lines) {
  char buffer[4096];
  const ssize_t count = ::read(out_, buffer, sizeof(buffer));
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  if (count == 0) return false;
  unread_.append(buffer, static_cast<std::size_t>(count));
  std::size_t end;
  while ((end = unread_.find('\n')) != std::string::npos) {
    lines->push_back(unread_.substr(0, end));
    unread_.erase(0, end + 1);
  }
  return true;
}

ProcessEnd WorkerProcess::End() {
  ProcessEnd end;
  Close(&in_), Close(&out_);
  if (pid_ == 0) return end;
  int status = 0;
  // One that has ended already keeps its own status.
  ::kill(pid_, SIGKILL);
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = 0;
  return EndOf(status);
}

}  // namespace latticeworld
