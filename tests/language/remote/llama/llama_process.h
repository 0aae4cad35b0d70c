#ifndef LATTICEWORLD_TESTS_LANGUAGE_REMOTE_LLAMA_LLAMA_PROCESS_H_
#define LATTICEWORLD_TESTS_LANGUAGE_REMOTE_LLAMA_LLAMA_PROCESS_H_

#include <sys/types.h>

#include <string>

namespace latticeworld {

// Real llama.cpp with a tiny model of random weights, as a process of its own on a free port of
// this machine, for as long as the object lives.
class LlamaProcess {
 public:
  // Writes the model and waits until the server listens; its output goes to the test's.
  LlamaProcess();
  ~LlamaProcess();
  LlamaProcess(const LlamaProcess&) = delete;
  LlamaProcess& operator=(const LlamaProcess&) = delete;

  // "http://127.0.0.1:40123/v1"; empty when it could not be started.
  const std::string& url() const { return url_; }

 private:
  pid_t pid_ = -1;
  std::string url_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_LANGUAGE_REMOTE_LLAMA_LLAMA_PROCESS_H_
