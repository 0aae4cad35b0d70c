#ifndef LATTICEWORLD_LANGUAGE_CHAT_HTTP_EXCHANGE_H_
#define LATTICEWORLD_LANGUAGE_CHAT_HTTP_EXCHANGE_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace latticeworld {

struct HttpRequest {
  std::string url;   // http or https
  std::string body;  // JSON; empty: GET, else POST
  std::string key;   // for "Authorization: Bearer"; empty: none
  std::string ca_file;
  bool is_loopback = false;  // then no proxy stands between, whatever the environment says
  double connect_timeout_s = 5.0;
  std::size_t max_body_bytes = 0;
};

// What the answer's header says.
struct HttpHead {
  int status = 0;  // 0: none has come
  std::string content_type;
  std::string retry_after;
  std::string date;
  std::string location;
};

enum class HttpEnd : std::uint8_t {
  kComplete,        // the whole body came
  kStopped,         // the handler wanted no more of the body
  kInterrupted,     // the handler interrupted it
  kConnectTimeout,  // no connection in time, TLS included
  kNoConnection,    // refused, no such host, ...
  kUntrusted,       // the certificate does not hold
  kBroken,          // the connection ended before the answer did
  kNotHttp,         // what answered does not speak HTTP
  kTooLarge,        // the body or the header is beyond its limit
};

struct HttpResult {
  HttpEnd end = HttpEnd::kComplete;
  HttpHead head;
  std::string detail;  // of a failure, in libcurl's words
};

// Hears an exchange while it goes on, in the thread that called Exchange.
class HttpHandler {
 public:
  virtual ~HttpHandler() = default;
  // More of the body. False: enough, the connection is closed.
  virtual bool OnBody(const HttpHead& head, std::string_view bytes) = 0;
  // Asked at least every 20 ms; true: the connection is closed at once.
  virtual bool Interrupted() = 0;
};

// One request and its answer, over a connection of its own. Certificates are verified, redirects
// are not followed (the key goes nowhere else), header and body are bounded, and no signal is
// raised. Any thread.
HttpResult Exchange(const HttpRequest& request, HttpHandler* handler);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CHAT_HTTP_EXCHANGE_H_
