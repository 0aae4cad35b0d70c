#include "tools/run_program.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

// In the child: nothing but calls that are safe after fork.
[[noreturn]] void StartProgram(char* const* arguments, const RunOptions& options, int out,
                               int err) {
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  if (options.max_file_bytes >= 0) {
    const rlim_t limit = static_cast<rlim_t>(options.max_file_bytes);
    const rlimit limits = {limit, limit};
    ::setrlimit(RLIMIT_FSIZE, &limits);
    ::signal(SIGXFSZ, SIG_IGN);  // so that a write fails as it does on a full disk
  }
  ::execv(arguments[0], arguments);
  ::_exit(127);
}

// Reads both pipes to their ends, so that neither fills up and stalls the program.
void ReadAll(int out, int err, pid_t child, int signal, ProgramRun* run) {
  pollfd pipes[2] = {{out, POLLIN, 0}, {err, POLLIN, 0}};
  std::string* texts[2] = {&run->out, &run->err};
  bool signalled = signal == 0;
  while (pipes[0].fd >= 0 || pipes[1].fd >= 0) {
    if (::poll(pipes, 2, -1) < 0) return;
    for (int i = 0; i < 2; ++i) {
      if (pipes[i].fd < 0 || pipes[i].revents == 0) continue;
      char buffer[65536];
      const ssize_t count = ::read(pipes[i].fd, buffer, sizeof(buffer));
      if (count <= 0) {
        pipes[i].fd = -1;
      } else {
        texts[i]->append(buffer, static_cast<std::size_t>(count));
      }
    }
    if (!signalled && !run->err.empty()) {
      ::kill(child, signal);
      signalled = true;
    }
  }
}

}  // namespace

ProgramRun RunProgram(const std::vector<std::string>& arguments, const RunOptions& options) {
  std::vector<std::string> strings = {LATTICEWORLD_PROGRAM};
  strings.insert(strings.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& string : strings) pointers.push_back(string.data());
  pointers.push_back(nullptr);

  ProgramRun run;
  int out[2], err[2];
  if (::pipe2(out, O_CLOEXEC) != 0 || ::pipe2(err, O_CLOEXEC) != 0) {
    ADD_FAILURE() << "no pipes";
    return run;
  }
  int out_target = out[1];
  if (!options.out_path.empty()) {
    out_target = ::open(options.out_path.c_str(), O_WRONLY | O_CLOEXEC);
  }
  const pid_t child = ::fork();
  if (child == 0) StartProgram(pointers.data(), options, out_target, err[1]);
  if (out_target != out[1]) ::close(out_target);
  ::close(out[1]);
  ::close(err[1]);
  ReadAll(out[0], err[0], child, options.signal, &run);
  ::close(out[0]);
  ::close(err[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFEXITED(status)) run.exit_status = WEXITSTATUS(status);
  return run;
}

ProgramTest::ProgramTest() {
  std::string name = (fs::temp_directory_path() / "lw-tools-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) ADD_FAILURE() << "cannot make " << name;
  directory_ = name;
}

ProgramTest::~ProgramTest() {
  std::error_code ignored;
  fs::remove_all(directory_, ignored);
}

void ProgramTest::Write(const std::string& name, const std::string& content) const {
  std::ofstream(directory_ / name, std::ios::binary) << content;
}

std::string ProgramTest::Read(const std::string& name) const {
  std::ostringstream content;
  content << std::ifstream(directory_ / name, std::ios::binary).rdbuf();
  return content.str();
}

std::vector<std::string> ProgramTest::Entries() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory_)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace latticeworld
