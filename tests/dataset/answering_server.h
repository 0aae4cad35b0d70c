#ifndef LATTICEWORLD_TESTS_DATASET_ANSWERING_SERVER_H_
#define LATTICEWORLD_TESTS_DATASET_ANSWERING_SERVER_H_

#include <sys/types.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace latticeworld {

// Runs answering_server.py while it lives.
class AnsweringServer {
 public:
  // answers: an array of texts, and of numbers for HTTP errors.
  explicit AnsweringServer(const nlohmann::json& answers);
  ~AnsweringServer();
  AnsweringServer(const AnsweringServer&) = delete;
  AnsweringServer& operator=(const AnsweringServer&) = delete;

  std::string url() const { return "http://127.0.0.1:" + port_ + "/v1"; }
  // The bodies of all requests so far.
  std::vector<nlohmann::json> Requests() const;

 private:
  std::string folder_;
  std::string port_;
  pid_t pid_ = -1;
  int stdin_ = -1;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_DATASET_ANSWERING_SERVER_H_
