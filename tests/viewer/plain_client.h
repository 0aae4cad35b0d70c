#ifndef LATTICEWORLD_TESTS_VIEWER_PLAIN_CLIENT_H_
#define LATTICEWORLD_TESTS_VIEWER_PLAIN_CLIENT_H_

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace latticeworld {

struct PlainResponse {
  int status = 0;                              // 0: the connection ended before there was one
  std::map<std::string, std::string> headers;  // names in lower case
  std::string body;
};

// A client over a bare socket, so that it can send what no library would. Every wait ends after
// 20 s, as a failure. Move-only.
class PlainClient {
 public:
  explicit PlainClient(int port);
  ~PlainClient();
  PlainClient(PlainClient&& other) noexcept;
  PlainClient(const PlainClient&) = delete;
  PlainClient& operator=(const PlainClient&) = delete;

  // False: the server has ended the connection.
  bool Send(const std::string& bytes);
  // True once the server ends the connection; what comes before is thrown away.
  bool WaitForEnd();
  PlainResponse ReadResponse(bool has_body = true);

  // A GET of 127.0.0.1 with more header lines, each ended by "\r\n".
  PlainResponse Get(const std::string& target, const std::string& headers = "");

  // WebSocket (RFC 6455). Upgrade gives the response to the handshake: 101.
  PlainResponse Upgrade(const std::string& headers = "", const std::string& host = "127.0.0.1");
  bool SendText(const std::string& text) { return SendFrame(1, text); }
  bool SendFrame(int opcode, const std::string& payload);
  struct Message {
    int opcode = 0;  // 0: the connection has ended; 1 text, 2 binary, 8 close
    std::string payload;
  };
  // The next message; pings are left out.
  Message ReadMessage();
  // The next text message for which `wanted` is true, others thrown away; null: it never came.
  nlohmann::json ReadUntil(const std::function<bool(const nlohmann::json&)>& wanted);
  nlohmann::json ReadType(const std::string& type);

 private:
  bool Fill();  // reads more; false at the end
  bool Need(std::size_t bytes);

  int socket_ = -1;
  std::string buffer_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_VIEWER_PLAIN_CLIENT_H_
