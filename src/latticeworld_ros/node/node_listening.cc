#include "latticeworld_ros/node/node_listening.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <ros/network.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>

namespace latticeworld {
namespace {

constexpr int kPatienceMs = 500;

// The error with which a connection to the address ends; 0: it stands, ETIMEDOUT: no answer.
int ErrorOfConnecting(const sockaddr_in& address) {
  const int connection = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (connection < 0) return errno;
  int error = 0;
  if (connect(connection, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) {
    error = errno;
  }
  if (error == EINPROGRESS) {
    pollfd waiting = {connection, POLLOUT, 0};
    socklen_t size = sizeof(error);
    if (poll(&waiting, 1, kPatienceMs) != 1) {
      error = ETIMEDOUT;
    } else if (getsockopt(connection, SOL_SOCKET, SO_ERROR, &error, &size) != 0) {
      error = errno;
    }
  }
  close(connection);
  return error;
}

}  // namespace

bool NobodyListensAt(const std::string& uri, const std::string& own_host) {
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(uri, host, port) || port == 0 || port > 65535) return false;
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  if (inet_pton(AF_INET, host.c_str(), &address.sin_addr) != 1) {
    if (host != own_host && host != "localhost") return false;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  }
  return ErrorOfConnecting(address) == ECONNREFUSED;
}

}  // namespace latticeworld
