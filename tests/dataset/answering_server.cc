#include "dataset/answering_server.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "latticeworld/common/check.h"

extern char** environ;

namespace latticeworld {

AnsweringServer::AnsweringServer(const nlohmann::json& answers) {
  folder_ = (std::filesystem::temp_directory_path() / "latticeworld_answers_XXXXXX").string();
  LW_CHECK(mkdtemp(folder_.data()) != nullptr, folder_);
  std::string file = folder_ + "/answers.json", log = folder_ + "/requests.jsonl";
  std::ofstream(file) << answers.dump();

  std::array<int, 2> in{}, out{};
  LW_CHECK(pipe2(in.data(), O_CLOEXEC) == 0 && pipe2(out.data(), O_CLOEXEC) == 0, "no pipes");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
  std::string python = PYTHON3, script = ANSWERING_SERVER;
  std::array<char*, 5> arguments = {python.data(), script.data(), file.data(), log.data(), nullptr};
  LW_CHECK(posix_spawn(&pid_, PYTHON3, &actions, nullptr, arguments.data(), environ) == 0, python);
  posix_spawn_file_actions_destroy(&actions);
  close(in[0]);
  close(out[1]);
  stdin_ = in[1];
  char letter = '\0';
  while (read(out[0], &letter, 1) == 1 && letter != '\n') port_ += letter;
  close(out[0]);
}

AnsweringServer::~AnsweringServer() {
  close(stdin_);
  kill(pid_, SIGTERM);
  waitpid(pid_, nullptr, 0);
  std::filesystem::remove_all(folder_);
}

std::vector<nlohmann::json> AnsweringServer::Requests() const {
  std::vector<nlohmann::json> requests;
  std::ifstream log(folder_ + "/requests.jsonl");
  for (std::string line; std::getline(log, line);) requests.push_back(nlohmann::json::parse(line));
  return requests;
}

}  // namespace latticeworld
