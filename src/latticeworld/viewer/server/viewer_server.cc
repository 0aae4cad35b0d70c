#include "latticeworld/viewer/server/viewer_server.h"

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <exception>
#include <thread>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/viewer/server/http_connection.h"
#include "latticeworld/viewer/server/server_core.h"

namespace latticeworld {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using tcp = asio::ip::tcp;

// The server waits this long after a failed accept (as when the system has no more files).
constexpr std::chrono::milliseconds kAcceptPause(100);

}  // namespace

std::vector<Violation> Validate(const ViewerServerOptions& options) {
  std::vector<Violation> violations;
  const auto refuse = [&violations](const char* name, const std::string& given,
                                    const std::string& legal) {
    violations.push_back({"out_of_range", name, given + " is not legal; legal is " + legal, given});
  };
  error_code error;
  (void)asio::ip::make_address(options.host, error);
  if (error && options.host != "localhost") {
    refuse("host", Quote(options.host), "localhost or a numeric address (0.0.0.0: all)");
  }
  const auto check = [&refuse](const char* name, int value, int low, int high) {
    if (value >= low && value <= high) return;
    refuse(name, std::to_string(value), std::to_string(low) + " .. " + std::to_string(high));
  };
  check("port", options.port, 0, 65535);
  check("max_connections", options.max_connections, 1, 10000);
  check("max_clients", options.max_clients, 1, 10000);
  for (const auto& [name, value] : {std::pair("header_timeout_s", options.header_timeout_s),
                                    std::pair("body_timeout_s", options.body_timeout_s),
                                    std::pair("silence_timeout_s", options.silence_timeout_s)}) {
    if (!(value > 0.0 && value <= 86400.0)) refuse(name, FormatDouble(value), "> 0 .. 86400");
  }
  return violations;
}

class ViewerServer::Impl {
 public:
  Impl(const ViewerServerOptions& options, PayloadMap page, ViewerBackend* backend)
      : core_(options, std::move(page), backend, mailbox_) {
    mailbox_->Open(&context_);
  }
  ~Impl() { Stop(); }

  Status Listen() {
    const ViewerServerOptions& options = core_.options();
    error_code error;
    const auto address =
        asio::ip::make_address(options.host == "localhost" ? "127.0.0.1" : options.host, error);
    const tcp::endpoint endpoint(address, static_cast<unsigned short>(options.port));
    if (!error) acceptor_.open(endpoint.protocol(), error);
    if (!error) acceptor_.set_option(asio::socket_base::reuse_address(true), error);
    if (!error) acceptor_.bind(endpoint, error);
    if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
    if (error) {
      return Unavailable("cannot listen at " + options.host + ":" + std::to_string(options.port) +
                         ": " + error.message());
    }
    port_ = acceptor_.local_endpoint(error).port();
    Accept();
    thread_ = std::thread([this] { Run(); });
    return Status();
  }

  void Stop() {
    mailbox_->Close();
    context_.stop();
    if (thread_.joinable()) thread_.join();
  }

  int port() const { return port_; }
  Mailbox& mailbox() { return *mailbox_; }
  ServerCore& core() { return core_; }

 private:
  void Run() {
    // What the standard library throws (no memory) ends what it happened in, nothing else.
    while (!context_.stopped()) {
      try {
        context_.run();
      } catch (const std::exception&) {
      }
    }
  }

  void Accept() {
    acceptor_.async_accept([this](error_code error, tcp::socket socket) {
      if (error) {
        pause_.expires_after(kAcceptPause);
        pause_.async_wait([this](error_code) { Accept(); });
        return;
      }
      Accept();
      if (!core_.has_room()) return;  // closes it
      error_code ignored;
      socket.set_option(tcp::no_delay(true), ignored);
      ServeConnection(std::move(socket), &core_);
    });
  }

  std::shared_ptr<Mailbox> mailbox_ = std::make_shared<Mailbox>();
  ServerCore core_;
  // Dies before the core: its handlers hold the connections, which point there.
  asio::io_context context_{1};
  tcp::acceptor acceptor_{context_};
  asio::steady_timer pause_{context_};
  int port_ = 0;
  std::thread thread_;
};

ViewerServer::ViewerServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ViewerServer::~ViewerServer() = default;

Result<std::unique_ptr<ViewerServer>> ViewerServer::Start(const ViewerServerOptions& options,
                                                          PayloadMap page, ViewerBackend* backend) {
  LW_RETURN_IF_ERROR(Status::FromViolations("options of the viewer", Validate(options)));
  auto impl = std::make_unique<Impl>(options, std::move(page), backend);
  LW_RETURN_IF_ERROR(impl->Listen());
  return std::unique_ptr<ViewerServer>(new ViewerServer(std::move(impl)));
}

void ViewerServer::Stop() { impl_->Stop(); }
int ViewerServer::port() const { return impl_->port(); }

void ViewerServer::SetWorld(std::shared_ptr<const WorldPayloads> world, const std::string& reason) {
  impl_->mailbox().Post(
      [core = &impl_->core(), world = std::move(world), reason] { core->SetWorld(world, reason); });
}

void ViewerServer::Tell(const std::string& slot, std::string text, Audience audience) {
  impl_->mailbox().Post([core = &impl_->core(), slot, text = std::move(text), audience]() mutable {
    core->Tell(slot, std::move(text), audience, /*remember=*/true);
  });
}

void ViewerServer::TellNow(const std::string& slot, std::string text) {
  impl_->mailbox().Post([core = &impl_->core(), slot, text = std::move(text)]() mutable {
    core->Tell(slot, std::move(text), Audience::kEverybody, /*remember=*/false);
  });
}

void ViewerServer::Forget(const std::string& slot, std::string text, Audience audience) {
  impl_->mailbox().Post([core = &impl_->core(), slot, text = std::move(text), audience]() mutable {
    core->Forget(slot, std::move(text), audience);
  });
}

void ViewerServer::TellOnce(std::string text) {
  impl_->mailbox().Post([core = &impl_->core(), text = std::move(text)]() mutable {
    core->TellOnce(std::move(text));
  });
}

void ViewerServer::Show(StreamKind kind, StreamFrame frame) {
  impl_->mailbox().Post(
      [core = &impl_->core(), kind, frame = std::move(frame)] { core->Show(kind, frame); });
}

void ViewerServer::ShowPoints(const std::string& robot, std::string points) {
  impl_->mailbox().Post([core = &impl_->core(), robot, points = std::move(points)]() mutable {
    core->ShowPoints(robot, std::move(points));
  });
}

}  // namespace latticeworld
