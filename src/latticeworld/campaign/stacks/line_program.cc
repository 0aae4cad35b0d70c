#include "latticeworld/campaign/stacks/line_program.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

using Clock = std::chrono::steady_clock;

// How long a program may take to end once its input has ended, and again once it is told to.
constexpr std::chrono::milliseconds kEnd(2000);

bool IsForNow(int error) { return error == EAGAIN || error == EWOULDBLOCK || error == EINTR; }

// Whether that process, a child of this one, ends in that time. It stays to be waited for.
bool EndsWithin(pid_t pid, std::chrono::milliseconds time) {
  const auto last = Clock::now() + time;
  for (;;) {
    siginfo_t info = {};
    if (::waitid(P_PID, static_cast<id_t>(pid), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
        info.si_pid == pid)
      return true;
    if (Clock::now() >= last) return false;
    ::poll(nullptr, 0, 5);
  }
}

// Ends the process, and what of its group is left then. It is told first: what it started may have
// left the group, and only it knows how to end that. Returns how it ended.
ProcessEnd EndGroup(pid_t pid, std::chrono::milliseconds patience) {
  if (!EndsWithin(pid, patience)) {
    ::kill(pid, SIGTERM);
    EndsWithin(pid, kEnd);
  }
  ::kill(-pid, SIGKILL);  // one that has ended already keeps its own status
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return EndOf(status);
}

}  // namespace

Result<LineProgram> LineProgram::Start(const std::vector<std::string>& command,
                                       const std::filesystem::path& folder) {
  ChildOptions options;
  options.folder = folder;
  options.own_group = true;
  options.death_signal = SIGTERM;  // it may have things of its own to end
  LW_ASSIGN_OR_RETURN(const ChildProcess child, StartChild(command, options));
  for (const int descriptor : {child.in, child.out})
    ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) | O_NONBLOCK);
  return LineProgram(child);
}

LineProgram::LineProgram(LineProgram&& other) noexcept
    : child_(std::exchange(other.child_, ChildProcess())), unread_(std::move(other.unread_)) {}

LineProgram::~LineProgram() {
  if (child_.in >= 0) ::close(child_.in);
  // Nobody reads it any more: a program that goes on talking must not wait for that.
  if (child_.out >= 0) ::close(child_.out);
  if (child_.pid > 0) EndGroup(child_.pid, kEnd);
}

Status LineProgram::Gone() {
  // It may be about to end by itself, with a status that says why.
  const ProcessEnd end = EndGroup(std::exchange(child_.pid, 0), std::chrono::milliseconds(200));
  if (end.exit_status == 127)
    return FailedPrecondition("the program cannot be run, or ended with status 127");
  if (end.signal == SIGKILL || end.signal == SIGTERM)
    return FailedPrecondition("the program closed its input or output, or was ended");
  return FailedPrecondition("the program " + end.ToString());
}

Result<std::string> LineProgram::Ask(std::string_view line, double answer_time_s) {
  if (child_.pid == 0) return FailedPrecondition("the program has ended");
  if (!unread_.empty())
    return InvalidArgument("the program said something that nobody asked for: " +
                           Quote(unread_.substr(0, 80)));
  // Writing and reading take turns as the pipes allow, so that neither side waits for the other.
  std::string left(line);
  left += '\n';
  std::size_t said = 0;
  const auto last = Clock::now() + std::chrono::duration<double>(answer_time_s);
  for (;;) {
    pollfd ends[2] = {{child_.out, POLLIN, 0}, {child_.in, POLLOUT, 0}};
    const auto time =
        std::chrono::duration_cast<std::chrono::milliseconds>(last - Clock::now()).count();
    const bool is_said = said == left.size();
    const int ready =
        time <= 0 ? 0
                  : ::poll(ends, is_said ? 1 : 2, static_cast<int>(std::min<long>(time, 60000)));
    if (ready < 0 && errno == EINTR) continue;
    if (ready == 0 && Clock::now() >= last) {
      return Status(StatusCode::kDeadlineExceeded,
                    "the program did not answer within " + FormatDouble(answer_time_s) + " s");
    }
    // As much of the question is written as the pipe takes.
    if (!is_said && (ends[1].revents & (POLLOUT | POLLERR)) != 0) {
      const ssize_t count = WriteQuietly(child_.in, left.data() + said, left.size() - said);
      if (count > 0) said += static_cast<std::size_t>(count);
      if (count < 0 && !IsForNow(errno)) return Gone();
    }
    // What has come is read, until it holds a whole line.
    if ((ends[0].revents & (POLLIN | POLLHUP)) == 0) continue;
    char buffer[16384];
    const ssize_t count = ::read(child_.out, buffer, sizeof(buffer));
    if (count == 0 || (count < 0 && !IsForNow(errno))) return Gone();
    if (count > 0) unread_.append(buffer, static_cast<std::size_t>(count));
    const std::size_t end = unread_.find('\n');
    if (end == std::string::npos && unread_.size() <= kMostBytes) continue;
    if (end == std::string::npos || end > kMostBytes)
      return InvalidArgument("the program answered with a line of more than " +
                             std::to_string(kMostBytes) + " bytes");
    std::string answer = unread_.substr(0, end);
    unread_.erase(0, end + 1);
    return answer;
  }
}

}  // namespace latticeworld
