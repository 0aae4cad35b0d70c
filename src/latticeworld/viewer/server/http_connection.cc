#include "latticeworld/viewer/server/http_connection.h"

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/span_body.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "latticeworld/viewer/server/http_answer.h"
#include "latticeworld/viewer/server/server_core.h"
#include "latticeworld/viewer/server/websocket_session.h"

namespace latticeworld {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
using beast::error_code;
using tcp = boost::asio::ip::tcp;

constexpr std::uint32_t kMostHeaderBytes = 8192;
// Scripts, pictures, data and sockets of this server alone; nobody else's page may hold it.
constexpr char kContentPolicy[] =
    "default-src 'self'; img-src 'self' data: blob:; style-src 'self' 'unsafe-inline'; "
    "connect-src 'self' blob: data:; worker-src 'self' blob:; object-src 'none'; base-uri 'none'; "
    "form-action 'none'; frame-ancestors 'none'";

std::chrono::milliseconds Milliseconds(double seconds) {
  return std::chrono::milliseconds(static_cast<std::int64_t>(seconds * 1000.0));
}

std::string Text(beast::string_view view) { return std::string(view.data(), view.size()); }

class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(tcp::socket socket, ServerCore* core)
      : count_(std::make_unique<ConnectionCount>(core)), stream_(std::move(socket)), core_(core) {}

  void Read() {
    parser_.emplace();
    parser_->header_limit(kMostHeaderBytes);
    parser_->body_limit(0);
    stream_.expires_after(Milliseconds(core_->options().header_timeout_s));
    http::async_read(
        stream_, input_, *parser_,
        [self = shared_from_this()](error_code error, std::size_t) { self->OnRequest(error); });
  }

 private:
  using Response = http::response<http::span_body<const char>>;

  void OnRequest(error_code error) {
    if (error == http::error::header_limit) {
      return Answer(HttpError(Status(StatusCode::kOutOfRange,
                                     "the header of a request has at most "
                                     "8192 bytes")),
                    /*keep=*/false);
    }
    if (error == http::error::body_limit) {
      return Answer(HttpError(InvalidArgument("requests have no body here")), false);
    }
    if (error && error.category() == http::make_error_code(http::error::bad_target).category() &&
        error != http::error::end_of_stream && error != http::error::partial_message) {
      return Answer(HttpError(InvalidArgument("no HTTP/1.1 request: " + error.message())), false);
    }
    if (error) return Close();
    const UpgradeRequest& request = parser_->get();
    const ClientFacts facts = FactsOf(request);
    if (const Status status = CheckHost(facts.host, core_->options().access); !status.ok()) {
      return Answer(HttpError(status), false);
    }
    if (Path(request) == "/ws") return OnWebSocket(request, facts);
    HttpQuestion question;
    question.method = Text(request.method_string());
    question.target = Text(request.target());
    question.if_none_match = Text(request[http::field::if_none_match]);
    question.accept_encoding = Text(request[http::field::accept_encoding]);
    Answer(AnswerHttp(question, core_->page(), core_->world()), request.keep_alive());
  }

  static std::string Path(const UpgradeRequest& request) {
    const std::string target = Text(request.target());
    return target.substr(0, target.find('?'));
  }

  ClientFacts FactsOf(const UpgradeRequest& request) {
    ClientFacts facts;
    error_code error;
    const tcp::endpoint peer = stream_.socket().remote_endpoint(error);
    if (!error) {
      const auto address = peer.address();
      facts.from_loopback =
          address.is_loopback() ||
          (address.is_v6() && address.to_v6().is_v4_mapped() &&
           boost::asio::ip::make_address_v4(boost::asio::ip::v4_mapped, address.to_v6())
               .is_loopback());
    }
    facts.forwarded = request.count(http::field::forwarded) > 0 ||
                      request.count("X-Forwarded-For") > 0 || request.count(http::field::via) > 0;
    facts.host = Text(request[http::field::host]);
    facts.origin = Text(request[http::field::origin]);
    return facts;
  }

  void OnWebSocket(const UpgradeRequest& request, const ClientFacts& facts) {
    if (!beast::websocket::is_upgrade(request)) {
      return Answer(HttpError(InvalidArgument("/ws is a WebSocket")), false);
    }
    if (const Status status = CheckOrigin(facts.origin, facts.host); !status.ok()) {
      return Answer(HttpError(status), false);
    }
    if (!core_->has_room_for_client()) {
      return Answer(HttpError(ResourceExhausted("as many clients as there may be look already")),
                    false);
    }
    StartWebSocket(std::move(stream_), request, facts, core_, std::move(count_));
  }

  void Answer(HttpAnswer answer, bool keep) {
    answer_ = std::move(answer);
    const bool is_head = parser_->is_header_done() && parser_->get().method() == http::verb::head;
    response_ = std::make_unique<Response>();
    response_->result(static_cast<unsigned>(answer_.status));
    response_->version(11);
    response_->keep_alive(keep);
    response_->set(http::field::content_type, answer_.content_type);
    response_->set(http::field::cache_control, answer_.cache_control);
    if (!answer_.etag.empty()) {
      response_->set(http::field::etag, answer_.etag);
      response_->set(http::field::vary, "Accept-Encoding");
    }
    if (answer_.is_gzip) response_->set(http::field::content_encoding, "gzip");
    if (answer_.status == 405) response_->set(http::field::allow, "GET, HEAD");
    response_->set("X-Content-Type-Options", "nosniff");
    response_->set("Content-Security-Policy", kContentPolicy);
    response_->set("Referrer-Policy", "no-referrer");
    response_->set("Cross-Origin-Resource-Policy", "same-origin");
    if (answer_.status != 304) response_->content_length(answer_.body.size());
    if (!is_head) {
      response_->body() = beast::span<const char>(answer_.body.data(), answer_.body.size());
    }
    stream_.expires_after(Milliseconds(core_->options().body_timeout_s));
    serializer_.emplace(*response_);
    http::async_write(stream_, *serializer_,
                      [self = shared_from_this(), keep](error_code error, std::size_t) {
                        if (error || !keep) return self->Close();
                        self->Read();
                      });
  }

  void Close() {
    error_code ignored;
    stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
  }

  std::unique_ptr<ConnectionCount> count_;
  beast::tcp_stream stream_;
  ServerCore* core_;
  beast::flat_buffer input_{kMostHeaderBytes * 2};
  std::optional<http::request_parser<http::empty_body>> parser_;
  HttpAnswer answer_;  // holds the body while it is sent
  std::unique_ptr<Response> response_;
  std::optional<http::response_serializer<http::span_body<const char>>> serializer_;
};

}  // namespace

void ServeConnection(tcp::socket socket, ServerCore* core) {
  std::make_shared<HttpConnection>(std::move(socket), core)->Read();
}

}  // namespace latticeworld
