// What a server answers to an HTTP request of ours, byte by byte: the head, the body in chunks or
// not, as libcurl and our client read them. A thread plays the server on the loopback.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <string>
#include <thread>

#include "fuzz/fuzz_target.h"
#include "latticeworld/language/chat/http_exchange.h"

namespace {

using namespace latticeworld;
using fuzz::Expect;

// A port on the loopback that answers each connection with the same bytes, whatever is asked.
class Server {
 public:
  Server() : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t length = sizeof(address);
    Expect(bind(socket_, reinterpret_cast<sockaddr*>(&address), length) == 0 &&
               listen(socket_, 1) == 0 &&
               getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &length) == 0,
           "there is a port on the loopback");
    port_ = ntohs(address.sin_port);
  }
  int port() const { return port_; }

  // Serves one connection, and reads it to its end.
  void Serve(std::string_view answer) const {
    const int connection = accept(socket_, nullptr, nullptr);
    std::string asked;
    char bytes[4096];
    for (ssize_t count; asked.find("\r\n\r\n") == std::string::npos &&
                        (count = recv(connection, bytes, sizeof(bytes), 0)) > 0;) {
      asked.append(bytes, static_cast<std::size_t>(count));
    }
    while (!answer.empty()) {
      const ssize_t sent = send(connection, answer.data(), answer.size(), MSG_NOSIGNAL);
      if (sent <= 0) break;
      answer.remove_prefix(static_cast<std::size_t>(sent));
    }
    shutdown(connection, SHUT_WR);
    while (recv(connection, bytes, sizeof(bytes), 0) > 0) {
    }
    close(connection);
  }

 private:
  int socket_;
  int port_ = 0;
};

class Handler : public HttpHandler {
 public:
  bool OnBody(const HttpHead&, std::string_view bytes) override {
    bytes_ += bytes.size();
    return true;
  }
  bool Interrupted() override { return false; }
  std::size_t bytes() const { return bytes_; }

 private:
  std::size_t bytes_ = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Server server;
  HttpRequest request;
  request.url = "http://127.0.0.1:" + std::to_string(server.port()) + "/v1/models";
  request.is_loopback = true;
  request.max_body_bytes = 65536;
  Handler handler;
  std::thread serving([&] { server.Serve(fuzz::TextOf(data, size)); });
  const HttpResult result = Exchange(request, &handler);
  serving.join();
  Expect(handler.bytes() <= request.max_body_bytes, "a body beyond the limit is not handed on");
  Expect(result.end != HttpEnd::kComplete || result.head.status != 0,
         "an answer that is whole has a status");
  return 0;
}
