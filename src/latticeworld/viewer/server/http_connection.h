#ifndef LATTICEWORLD_VIEWER_SERVER_HTTP_CONNECTION_H_
#define LATTICEWORLD_VIEWER_SERVER_HTTP_CONNECTION_H_

#include <boost/asio/ip/tcp.hpp>

namespace latticeworld {

class ServerCore;

// Serves one connection until it ends: requests one after the other, or a WebSocket. It lives by
// itself on the server's thread, and counts in the core's connections while it does.
void ServeConnection(boost::asio::ip::tcp::socket socket, ServerCore* core);

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_SERVER_HTTP_CONNECTION_H_
