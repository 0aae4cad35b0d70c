#include "latticeworld_ros/node/node_listening.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>

namespace latticeworld {
namespace {

// A port of this machine that is held from its making to its end, listened to or not.
class Port {
 public:
  explicit Port(bool listens) : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(address);
    auto* any = reinterpret_cast<sockaddr*>(&address);
    ok_ = bind(socket_, any, size) == 0 && getsockname(socket_, any, &size) == 0 &&
          (!listens || listen(socket_, 8) == 0);
    number_ = std::to_string(ntohs(address.sin_port));
  }
  ~Port() { close(socket_); }
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;

  bool ok() const { return ok_; }
  std::string UriAt(const std::string& host) const {
    return "http://" + host + ":" + number_ + "/";
  }

 private:
  int socket_;
  bool ok_ = false;
  std::string number_;
};

TEST(NodeListeningTest, ANodeThatListensIsThere) {
  const Port port(/*listens=*/true);
  ASSERT_TRUE(port.ok());
  EXPECT_FALSE(NobodyListensAt(port.UriAt("127.0.0.1"), "here"));
  EXPECT_FALSE(NobodyListensAt(port.UriAt("here"), "here"));
  EXPECT_FALSE(NobodyListensAt(port.UriAt("localhost"), "here"));
}

TEST(NodeListeningTest, NobodyListensWhereAConnectionIsRefused) {
  const Port port(/*listens=*/false);
  ASSERT_TRUE(port.ok());
  EXPECT_TRUE(NobodyListensAt(port.UriAt("127.0.0.1"), "here"));
  EXPECT_TRUE(NobodyListensAt(port.UriAt("here"), "here"));
  EXPECT_TRUE(NobodyListensAt(port.UriAt("localhost"), "here"));
}

TEST(NodeListeningTest, WhatIsInDoubtCountsAsThere) {
  const Port port(/*listens=*/false);
  ASSERT_TRUE(port.ok());
  EXPECT_FALSE(NobodyListensAt(port.UriAt("elsewhere"), "here"));
  EXPECT_FALSE(NobodyListensAt("", "here"));
  EXPECT_FALSE(NobodyListensAt("http://127.0.0.1", "here"));
  EXPECT_FALSE(NobodyListensAt("http://127.0.0.1:99999/", "here"));
}

}  // namespace
}  // namespace latticeworld
