// A connection to the page's server, byte by byte as a client sends it: HTTP requests, the upgrade
// to a WebSocket, its frames and the requests in them. A client waits for the answer to its first
// head before it sends more, or the server would drop it. One thread, and no network. An input that
// begins with '{' is the text of one message.

#include <sys/socket.h>

#include <boost/asio/io_context.hpp>
#include <chrono>

#include "fuzz/fuzz_target.h"
#include "latticeworld/viewer/server/http_connection.h"
#include "latticeworld/viewer/server/server_core.h"
#include "latticeworld/viewer/server/viewer_request.h"

namespace {

using namespace latticeworld;
using boost::asio::ip::tcp;

// Says yes to everything.
class Backend : public ViewerBackend {
 public:
  void Do(const ViewerRequest&, Done done) override { done(ViewerReply()); }
  void OnDemand(const LayerDemand&) override {}
};

PayloadMap Page() {
  PayloadMap page;
  page.emplace("/", MakePayload("text/html", std::string(4000, 'a'), true));
  return page;
}

// Sends all that there is room for.
void Send(int socket, std::string_view bytes) {
  (void)!send(socket, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
}

// Takes what the server has sent.
void Drain(int socket) {
  char bytes[4096];
  while (recv(socket, bytes, sizeof(bytes), MSG_DONTWAIT) > 0) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input = fuzz::TextOf(data, size);
  if (!input.empty() && input.front() == '{') {
    std::string id, type;
    (void)ParseRequest(input, &id, &type);
    return 0;
  }
  constexpr std::string_view kEndOfHead = "\r\n\r\n";
  const std::size_t end = input.find(kEndOfHead);
  const std::string_view first =
      end == std::string_view::npos ? input : input.substr(0, end + kEndOfHead.size());
  int ends[2];
  fuzz::Expect(socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0, "there is a pair of sockets");
  Backend backend;
  boost::asio::io_context context;
  const auto mailbox = std::make_shared<Mailbox>();
  mailbox->Open(&context);
  ViewerServerOptions options;
  options.access.token = "secret";
  ServerCore core(options, Page(), &backend, mailbox);
  Send(ends[0], first);
  ServeConnection(tcp::socket(context, tcp::v4(), ends[1]), &core);
  while (context.poll() > 0) {
  }
  Drain(ends[0]);
  Send(ends[0], input.substr(first.size()));
  shutdown(ends[0], SHUT_WR);  // that direction ends
  for (int idle = 0; !context.stopped(); ++idle) {
    if (context.poll() > 0) idle = 0;
    Drain(ends[0]);
    // The client has said all: what goes on waits for nobody.
    fuzz::Expect(idle < 10000, "a connection ends once its client has ended it");
    if (!context.stopped()) context.run_one_for(std::chrono::milliseconds(1));
  }
  mailbox->Close();
  close(ends[0]);
  return 0;
}
