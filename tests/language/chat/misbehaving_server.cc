#include "language/chat/misbehaving_server.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "latticeworld/common/check.h"

namespace latticeworld {

MisbehavingServer::MisbehavingServer() {
  folder_ = (std::filesystem::temp_directory_path() / "latticeworld_chat_XXXXXX").string();
  LW_CHECK(mkdtemp(folder_.data()) != nullptr, folder_);
  int to_server[2];
  int from_server[2];
  LW_CHECK(pipe2(to_server, O_CLOEXEC) == 0 && pipe2(from_server, O_CLOEXEC) == 0, "no pipes");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, to_server[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, from_server[1], STDOUT_FILENO);
  std::string python = PYTHON3;
  std::string script = MISBEHAVING_SERVER;
  char* arguments[] = {python.data(), script.data(), folder_.data(), nullptr};
  LW_CHECK(posix_spawn(&pid_, PYTHON3, &actions, nullptr, arguments, environ) == 0, python);
  posix_spawn_file_actions_destroy(&actions);
  close(to_server[0]);
  close(from_server[1]);
  stdin_ = to_server[1];

  std::string line;
  char c;
  while (read(from_server[0], &c, 1) == 1 && c != '\n') line += c;
  close(from_server[0]);
  started_ = nlohmann::json::parse(line);
}

MisbehavingServer::~MisbehavingServer() {
  close(stdin_);
  kill(pid_, SIGTERM);
  waitpid(pid_, nullptr, 0);
  std::filesystem::remove_all(folder_);
}

std::vector<nlohmann::json> MisbehavingServer::Log(const char* file,
                                                   const std::string& scenario) const {
  std::ifstream log(folder_ + "/" + file);
  std::vector<nlohmann::json> lines;
  for (std::string line; std::getline(log, line);) {
    nlohmann::json entry = nlohmann::json::parse(line);
    const std::string path = entry.at("path");
    if (path.rfind("/" + scenario + "/", 0) == 0) lines.push_back(std::move(entry));
  }
  return lines;
}

std::string MisbehavingServer::Address(const char* scheme, const char* port,
                                       const std::string& scenario) const {
  return std::string(scheme) + "://127.0.0.1:" + std::to_string(started_.at(port).get<int>()) +
         "/" + scenario + "/v1";
}

}  // namespace latticeworld
