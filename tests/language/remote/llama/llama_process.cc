#include "language/remote/llama/llama_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <vector>

extern char** environ;

namespace latticeworld {
namespace {

// Starts a program in the directory of the installed packages; its standard output goes to `out`
// (-1: this process's). Returns its id, or -1.
pid_t Start(std::initializer_list<std::string> arguments, int out) {
  std::vector<char*> words;
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.data()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, LLAMA_DIRECTORY);
  if (out >= 0) posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
  pid_t pid = -1;
  const int error = posix_spawn(&pid, words[0], &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? pid : -1;
}

}  // namespace

LlamaProcess::LlamaProcess() {
  std::string directory = LLAMA_DIRECTORY "/model.XXXXXX";
  if (mkdtemp(directory.data()) == nullptr) return;
  const std::string model = directory + "/tiny-noise.gguf";
  const pid_t writer = Start({PYTHON, LLAMA_SOURCES "/write_tiny_gguf.py", model}, -1);
  int status = -1;
  std::array<int, 2> ends;
  if (writer < 0 || waitpid(writer, &status, 0) != writer || status != 0 ||
      pipe2(ends.data(), O_CLOEXEC) != 0) {
    return;
  }
  pid_ = Start({LLAMA_DIRECTORY "/node", LLAMA_SOURCES "/llama_server.mjs", model}, ends[1]);
  close(ends[1]);
  // One line once it listens; the end of the file when it died before.
  FILE* output = fdopen(ends[0], "r");
  std::array<char, 256> line;
  const std::string sign = "listening on ";
  while (url_.empty() && fgets(line.data(), line.size(), output) != nullptr) {
    const std::string text(line.data());
    if (text.compare(0, sign.size(), sign) != 0) continue;
    url_ = text.substr(sign.size(), text.find_last_not_of('\n') + 1 - sign.size()) + "/v1";
  }
  fclose(output);
  // It is loaded; nothing stays behind.
  unlink(model.c_str());
  rmdir(directory.c_str());
}

LlamaProcess::~LlamaProcess() {
  if (pid_ < 0) return;
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

}  // namespace latticeworld
