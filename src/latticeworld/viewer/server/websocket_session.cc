#include "latticeworld/viewer/server/websocket_session.h"

#include <boost/asio/buffer.hpp>
#include <boost/beast/core/bind_handler.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <chrono>
#include <string_view>
#include <utility>

#include "latticeworld/viewer/server/client_conversation.h"
#include "latticeworld/viewer/server/server_core.h"
#include "latticeworld/viewer/server/viewer_request.h"

namespace latticeworld {
namespace {

namespace beast = boost::beast;
namespace websocket = beast::websocket;
using beast::error_code;

// A client that is sent away has this long to answer.
constexpr std::chrono::seconds kFarewell(2);

std::chrono::milliseconds Milliseconds(double seconds) {
  return std::chrono::milliseconds(static_cast<std::int64_t>(seconds * 1000.0));
}

double Now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Reads what a client says and writes what waits for it, one message at a time each.
class WebSocketSession : public std::enable_shared_from_this<WebSocketSession> {
 public:
  WebSocketSession(beast::tcp_stream stream, const ClientFacts& facts, ServerCore* core,
                   std::unique_ptr<ConnectionCount> count)
      : count_(std::move(count)),
        socket_(std::move(stream)),
        facts_(facts),
        core_(core),
        silence_(Milliseconds(core->options().silence_timeout_s)) {}
  ~WebSocketSession() { conversation_->End(); }
  WebSocketSession(const WebSocketSession&) = delete;
  WebSocketSession& operator=(const WebSocketSession&) = delete;

  void Start(const UpgradeRequest& request) {
    conversation_ = std::make_shared<ClientConversation>(core_, facts_, [this] { WriteNext(); });
    beast::get_lowest_layer(socket_).expires_never();
    socket_.set_option(
        websocket::stream_base::timeout{silence_, silence_, /*keep_alive_pings=*/true});
    socket_.read_message_max(kMaxRequestBytes);
    socket_.auto_fragment(false);
    socket_.async_accept(request, [self = shared_from_this()](error_code error) {
      if (error) return;
      self->is_open_ = true;
      self->conversation_->Begin();
      self->Read();
    });
  }

 private:
  void Read() {
    socket_.async_read(input_, [self = shared_from_this()](error_code error, std::size_t) {
      if (error) return self->Close();
      self->OnMessage();
    });
  }

  void OnMessage() {
    const auto bytes = input_.data();
    const bool goes_on =
        conversation_->Hear(std::string_view(static_cast<const char*>(bytes.data()), bytes.size()),
                            socket_.got_text(), Now_s());
    input_.consume(input_.size());
    if (goes_on && is_open_) return Read();
    Leave();
  }

  void WriteNext() {
    if (!is_open_ || writing_.bytes != nullptr) return;
    std::optional<OutMessage> next = conversation_->outbox().Next();
    if (!next) return;
    writing_ = *std::move(next);
    socket_.binary(writing_.binary);
    socket_.async_write(boost::asio::buffer(*writing_.bytes),
                        [self = shared_from_this()](error_code error, std::size_t) {
                          self->writing_ = {};
                          if (error) return self->Close();
                          self->WriteNext();
                        });
  }

  // Sends away a client that goes on beyond what is legal: says so, and does not wait long for an
  // answer.
  void Leave() {
    if (!is_open_) return;
    is_open_ = false;
    conversation_->End();
    socket_.set_option(websocket::stream_base::timeout{kFarewell, silence_, false});
    socket_.async_close({websocket::close_code::policy_error, "too many messages"},
                        [self = shared_from_this()](error_code) { self->Close(); });
  }

  void Close() {
    is_open_ = false;
    conversation_->End();
    beast::get_lowest_layer(socket_).close();
  }

  std::unique_ptr<ConnectionCount> count_;
  websocket::stream<beast::tcp_stream> socket_;
  const ClientFacts facts_;
  ServerCore* core_;
  const std::chrono::milliseconds silence_;
  std::shared_ptr<ClientConversation> conversation_;
  beast::flat_buffer input_;
  OutMessage writing_;  // no bytes: nothing is being written
  bool is_open_ = false;
};

}  // namespace

ConnectionCount::ConnectionCount(ServerCore* core) : core_(core) { core_->OnConnect(); }
ConnectionCount::~ConnectionCount() { core_->OnDisconnect(); }

void StartWebSocket(beast::tcp_stream stream, const UpgradeRequest& request,
                    const ClientFacts& facts, ServerCore* core,
                    std::unique_ptr<ConnectionCount> count) {
  std::make_shared<WebSocketSession>(std::move(stream), facts, core, std::move(count))
      ->Start(request);
}

}  // namespace latticeworld
