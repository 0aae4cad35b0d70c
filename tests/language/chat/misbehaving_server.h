#ifndef LATTICEWORLD_TESTS_LANGUAGE_CHAT_MISBEHAVING_SERVER_H_
#define LATTICEWORLD_TESTS_LANGUAGE_CHAT_MISBEHAVING_SERVER_H_

#include <sys/types.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace latticeworld {

// Runs misbehaving_server.py while it lives. Each scenario keeps a count of its requests, so a test
// takes a server of its own.
class MisbehavingServer {
 public:
  MisbehavingServer();
  ~MisbehavingServer();
  MisbehavingServer(const MisbehavingServer&) = delete;
  MisbehavingServer& operator=(const MisbehavingServer&) = delete;

  // Base address of a scenario; over TLS with a certificate of our own, with one that is made out
  // to another host, or with one of 2020; of a port where nobody listens.
  std::string Url(const std::string& scenario) const { return Address("http", "port", scenario); }
  std::string TlsUrl(const std::string& scenario) const {
    return Address("https", "tls_port", scenario);
  }
  std::string ForeignTlsUrl(const std::string& scenario) const {
    return Address("https", "foreign_port", scenario);
  }
  std::string ExpiredTlsUrl(const std::string& scenario) const {
    return Address("https", "expired_port", scenario);
  }
  // TLS to the port that speaks none: the handshake never ends. Whatever scenario it names, the
  // server takes it for a request of "tls_hello".
  std::string HangingTlsUrl(const std::string& scenario) const {
    return Address("https", "port", scenario);
  }
  std::string RefusingUrl() const { return Address("http", "refusing_port", "any"); }
  std::string certificate() const { return started_.at("tls_certificate"); }
  std::string foreign_certificate() const { return started_.at("foreign_certificate"); }
  std::string expired_certificate() const { return started_.at("expired_certificate"); }

  // What the server was asked so far under this scenario: {method, path, headers, body, time_s},
  // the time [s] on a clock that never goes back.
  std::vector<nlohmann::json> Requests(const std::string& scenario) const {
    return Log("requests.jsonl", scenario);
  }
  // How many connections of such requests the server has seen the other side close.
  std::size_t Closed(const std::string& scenario) const {
    return Log("closed.jsonl", scenario).size();
  }

 private:
  // The lines of a file of the server that are about this scenario.
  std::vector<nlohmann::json> Log(const char* file, const std::string& scenario) const;
  std::string Address(const char* scheme, const char* port, const std::string& scenario) const;

  std::string folder_;
  pid_t pid_ = -1;
  int stdin_ = -1;  // the server ends when this closes, also when the test dies
  nlohmann::json started_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_LANGUAGE_CHAT_MISBEHAVING_SERVER_H_
