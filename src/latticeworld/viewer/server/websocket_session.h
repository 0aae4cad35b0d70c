#ifndef LATTICEWORLD_VIEWER_SERVER_WEBSOCKET_SESSION_H_
#define LATTICEWORLD_VIEWER_SERVER_WEBSOCKET_SESSION_H_

#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <memory>

#include "latticeworld/viewer/server/access.h"

namespace latticeworld {

class ServerCore;

// Counts a connection while it lives.
class ConnectionCount {
 public:
  explicit ConnectionCount(ServerCore* core);
  ~ConnectionCount();
  ConnectionCount(const ConnectionCount&) = delete;
  ConnectionCount& operator=(const ConnectionCount&) = delete;

 private:
  ServerCore* core_;
};

using UpgradeRequest = boost::beast::http::request<boost::beast::http::empty_body>;

// Makes a WebSocket of a connection that asked for one and may have it; it lives by itself.
void StartWebSocket(boost::beast::tcp_stream stream, const UpgradeRequest& request,
                    const ClientFacts& facts, ServerCore* core,
                    std::unique_ptr<ConnectionCount> count);

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_SERVER_WEBSOCKET_SESSION_H_
