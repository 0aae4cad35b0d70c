#include "latticeworld/campaign/stacks/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <system_error>

namespace latticeworld {
namespace {

// Runs in the child, which makes nothing but calls that are safe after fork.
[[noreturn]] void RunProgram(char* const* arguments, const char* folder, bool own_group,
                             int death_signal, int in, int out, pid_t parent) {
  if (own_group) ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, death_signal);
  if (::getppid() != parent) ::_exit(1);  // the parent was gone before it was asked for
  // An interrupt at the terminal is for the parent, which ends its children.
  ::signal(SIGINT, SIG_IGN);
  ::signal(SIGPIPE, SIG_DFL);
  ::dup2(in, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  if (*folder != '\0' && ::chdir(folder) != 0) ::_exit(127);
  ::execvp(arguments[0], arguments);
  ::_exit(127);
}

void ClosePipe(const int (&ends)[2]) {
  ::close(ends[0]);
  ::close(ends[1]);
}

}  // namespace

std::string ProcessEnd::ToString() const {
  return exit_status >= 0 ? "ended with status " + std::to_string(exit_status)
                          : "was ended by signal " + std::to_string(signal);
}

ssize_t WriteQuietly(int descriptor, const char* data, std::size_t size) {
  sigset_t pipe_set, before;
  sigemptyset(&pipe_set);
  sigaddset(&pipe_set, SIGPIPE);
  ::pthread_sigmask(SIG_BLOCK, &pipe_set, &before);
  const ssize_t written = ::write(descriptor, data, size);
  const int error = errno;
  const timespec no_time = {0, 0};
  if (written < 0 && error == EPIPE) ::sigtimedwait(&pipe_set, nullptr, &no_time);
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = error;
  return written;
}

ProcessEnd EndOf(int wait_status) {
  ProcessEnd end;
  if (WIFEXITED(wait_status)) end.exit_status = WEXITSTATUS(wait_status);
  if (WIFSIGNALED(wait_status)) end.signal = WTERMSIG(wait_status);
  return end;
}

bool IsProgram(const std::string& program, const std::filesystem::path& folder) {
  const auto is_runnable = [](const std::filesystem::path& path) {
    std::error_code error;
    return std::filesystem::is_regular_file(path, error) && ::access(path.c_str(), X_OK) == 0;
  };
  if (program.empty()) return false;
  if (program.find('/') != std::string::npos) return is_runnable(folder / program);
  const char* const path = std::getenv("PATH");
  std::istringstream directories(path != nullptr ? path : "/usr/bin:/bin");
  for (std::string directory; std::getline(directories, directory, ':');) {
    if (is_runnable(std::filesystem::path(directory.empty() ? "." : directory) / program))
      return true;
  }
  return false;
}

Result<ChildProcess> StartChild(const std::vector<std::string>& command,
                                const ChildOptions& options) {
  std::vector<char*> arguments;
  for (const std::string& part : command) arguments.push_back(const_cast<char*>(part.c_str()));
  arguments.push_back(nullptr);
  const std::string folder = options.folder.string();
  int to[2], from[2];
  if (::pipe2(to, O_CLOEXEC) != 0)
    return ResourceExhausted(std::string("cannot make a pipe: ") + std::strerror(errno));
  if (::pipe2(from, O_CLOEXEC) != 0) {
    const int error = errno;
    ClosePipe(to);
    return ResourceExhausted(std::string("cannot make a pipe: ") + std::strerror(error));
  }
  const pid_t parent = ::getpid();
  const pid_t pid = ::fork();
  if (pid == 0) {
    RunProgram(arguments.data(), folder.c_str(), options.own_group, options.death_signal, to[0],
               from[1], parent);
  }
  if (pid < 0) {
    const int error = errno;
    ClosePipe(to);
    ClosePipe(from);
    return ResourceExhausted(std::string("cannot start a process: ") + std::strerror(error));
  }
  // Both do it: whoever is first, the group is there before anybody looks for it.
  if (options.own_group) ::setpgid(pid, pid);
  ::close(to[0]);
  ::close(from[1]);
  return ChildProcess{pid, to[1], from[0]};
}

}  // namespace latticeworld
