#ifndef LATTICEWORLD_LANGUAGE_CHAT_HTTP_EXCHANGE_H_
#define LATTICEWORLD_LANGUAGE_CHAT_HTTP_EXCHANGE_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace latticeworld {

// HttpRequest is what is asked of a server, and within which bounds.
struct HttpRequest {
  std::string url;   // http or https
  std::string body;  // JSON; empty: GET, else POST
  std::string key;   // for "Authorization: Bearer"; empty: none
  std::string ca_file;
  bool is_loopback = false;  // then no proxy stands between, whatever the environment says
  double connect_timeout_s = 5.0;
  std::size_t max_body_bytes = 0;
};

// HttpHead is what the answer's header says.
struct HttpHead {
  int status = 0;  // 0: none has come
  std::string content_type;
  std::string retry_after;
  std::string date;
  std::string location;
};

// HttpEnd says how an exchange ended.
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
  std::string detail;  // what failed, in libcurl's words
};

// HttpHandler hears an exchange while it goes on, in the thread that called Exchange.
class HttpHandler {
 public:
  virtual ~HttpHandler() = default;
  // Takes the next bytes of the body. Returning false means that these are enough, and the
  // connection is closed.
  virtual bool OnBody(const HttpHead& head, std::string_view bytes) = 0;
  // Is asked at least every 20 ms. Returning true closes the connection at once.
  virtual bool Interrupted() = 0;
};

// Sends one request and hears its answer, over a connection of its own. Certificates are verified,
// redirects are not followed (the key goes nowhere else), header and body are bounded, and no
// signal is raised. May be called in any thread.
HttpResult Exchange(const HttpRequest& request, HttpHandler* handler);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CHAT_HTTP_EXCHANGE_H_
