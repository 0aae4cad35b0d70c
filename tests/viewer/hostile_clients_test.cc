#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "viewer/viewer_fixture.h"

namespace latticeworld {
namespace {

using nlohmann::json;

class HostileClientsTest : public ViewerServerTest {
 protected:
  // Whatever was done to it, the server still serves.
  void ExpectAlive() {
    PlainClient client = Connect();
    EXPECT_EQ(client.Get("/").status, 200);
    PlainClient socket = Connect();
    EXPECT_EQ(socket.Upgrade().status, 101);
    EXPECT_EQ(socket.ReadType("hello").at("type"), "hello");
  }
};

TEST_F(HostileClientsTest, GarbageEndsItsConnectionOnly) {
  Start();
  for (const std::string& garbage :
       {std::string("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", 11), std::string(3000, '\0'),
        std::string("GET\r\n\r\n"), std::string("GET / HTTP/9.7\r\nHost: localhost\r\n\r\n"),
        std::string("POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: -5\r\n\r\n")}) {
    PlainClient client = Connect();
    client.Send(garbage);
    EXPECT_TRUE(client.WaitForEnd());
  }
  ExpectAlive();
}

TEST_F(HostileClientsTest, AHeaderOfTenMegabytesIsNotRead) {
  Start();
  PlainClient client = Connect();
  client.Send("GET / HTTP/1.1\r\nHost: localhost\r\nX: ");
  const std::string piece(1 << 20, 'a');
  int sent = 0;
  while (sent < 10 && client.Send(piece)) ++sent;
  EXPECT_TRUE(client.WaitForEnd());
  ExpectAlive();
}

TEST_F(HostileClientsTest, BodiesAndOtherMethodsAreRefused) {
  Start();
  PlainClient client = Connect();
  client.Send("POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 1000000\r\n\r\nxx");
  const PlainResponse post = client.ReadResponse();
  EXPECT_EQ(post.status, 400);
  PlainClient other = Connect();
  other.Send("DELETE / HTTP/1.1\r\nHost: localhost\r\n\r\n");
  const PlainResponse refused = other.ReadResponse();
  EXPECT_EQ(refused.status, 405);
  EXPECT_EQ(refused.headers.at("allow"), "GET, HEAD");
  EXPECT_EQ(json::parse(refused.body).at("code"), "UNIMPLEMENTED");
}

TEST_F(HostileClientsTest, NoPathLeadsOutOfThePage) {
  Start();
  server().SetWorld(SmallWorld(), "");
  PlainClient client = Connect();
  for (const std::string& path : std::vector<std::string>{
           "/../../../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "//etc/passwd", "/.", "/./",
           "/app.js/../app.js", "/app.js%00.html", "/api/worlds/../../etc/passwd", "/api/worlds/",
           "/api/worlds/another/height.bin", "/APP.JS", "*"}) {
    EXPECT_EQ(client.Get(path).status, 404) << path;
  }
  EXPECT_EQ(client.Get("/app.js?../../etc/passwd").body, "1;");
}

TEST_F(HostileClientsTest, OtherPagesAndHostsAreRefused) {
  Start();
  const auto upgrade = [this](const std::string& headers, const std::string& host) {
    return Connect().Upgrade(headers, host).status;
  };
  EXPECT_EQ(upgrade("Origin: http://127.0.0.1:8080\r\n", "127.0.0.1:8080"), 101);
  EXPECT_EQ(upgrade("Origin: http://evil.example\r\n", "127.0.0.1:8080"), 403);
  EXPECT_EQ(upgrade("Origin: http://127.0.0.1:9999\r\n", "127.0.0.1:8080"), 403);
  EXPECT_EQ(upgrade("Origin: null\r\n", "127.0.0.1:8080"), 403);
  // A name that another's page may have pointed at this machine.
  EXPECT_EQ(upgrade("Origin: http://evil.example\r\n", "evil.example"), 403);
  PlainClient client = Connect();
  client.Send("GET /api/world.json HTTP/1.1\r\nHost: evil.example\r\n\r\n");
  EXPECT_EQ(client.ReadResponse().status, 403);
  PlainClient nameless = Connect();
  nameless.Send("GET / HTTP/1.1\r\n\r\n");
  EXPECT_EQ(nameless.ReadResponse().status, 403);
}

TEST_F(HostileClientsTest, WhoMayOnlyLookCannotControl) {
  ViewerServerOptions options;
  options.port = 0;
  options.access.token = "a long secret";
  options.access.require_token = true;
  Start(options);
  PlainClient client = Connect();
  ASSERT_EQ(client.Upgrade().status, 101);
  EXPECT_EQ(client.ReadType("hello").at("role"), "viewer");
  for (const std::string& type :
       std::vector<std::string>{"pause", "unpause", "cancel", "step", "reset"}) {
    client.SendText(json{{"type", type}}.dump());
    EXPECT_EQ(client.ReadType("reply").at("code"), "PERMISSION_DENIED") << type;
  }
  client.SendText(R"({"type": "drive", "robot": "robot", "linear_mps": 1})");
  EXPECT_EQ(client.ReadType("reply").at("code"), "PERMISSION_DENIED");
  EXPECT_EQ(backend().requests(), 0u);
  client.SendText(R"({"type": "authenticate", "token": "a long secre"})");
  EXPECT_EQ(client.ReadType("reply").at("code"), "UNAUTHENTICATED");
  client.SendText(R"({"type": "authenticate", "token": "a long secret"})");
  EXPECT_EQ(client.ReadType("hello").at("role"), "controller");
  client.SendText(R"({"type": "pause"})");
  EXPECT_EQ(backend().WaitForRequest().type, RequestType::kPause);
}

TEST_F(HostileClientsTest, TokensCannotBeTriedOneAfterTheOther) {
  ViewerServerOptions options;
  options.port = 0;
  options.access.token = "secret";
  options.access.require_token = true;
  Start(options);
  PlainClient client = Connect();
  ASSERT_EQ(client.Upgrade().status, 101);
  int tried = 0;
  for (int i = 0; i < 20; ++i) {
    client.SendText(json{{"type", "authenticate"}, {"token", std::to_string(i)}}.dump());
    if (client.ReadType("reply").at("code") == "UNAUTHENTICATED") ++tried;
  }
  EXPECT_LE(tried, 7);
}

TEST_F(HostileClientsTest, MessagesThatAreNoRequestsAreAnsweredAndNothingIsDone) {
  Start();
  PlainClient client = Connect();
  ASSERT_EQ(client.Upgrade().status, 101);
  client.ReadType("hello");
  for (const std::string& text : std::vector<std::string>{
           "", "{", "[]", "42", "{\"type\": 3}", "{\"type\": \"launch_missiles\"}",
           "{\"type\": \"pause\", \"type\": \"unpause\"}", "{\"a\":{\"b\":{\"c\":{\"d\":{}}}}}"}) {
    client.SendText(text);
    const json answer = client.ReadUntil([](const json&) { return true; });
    EXPECT_EQ(answer.at("type"), "error") << text;
    EXPECT_EQ(answer.at("code"), "INVALID_ARGUMENT") << text;
  }
  client.SendText(R"({"type": "drive", "robot": "../x", "linear_mps": 1e9, "speed": 1})");
  const json answer = client.ReadType("reply");
  EXPECT_EQ(answer.at("code"), "INVALID_ARGUMENT");
  for (const char* word : {"robot", "linear_mps", "speed"}) {
    EXPECT_NE(answer.at("message").get<std::string>().find(word), std::string::npos) << word;
  }
  client.SendFrame(2, "\x01\x02");
  EXPECT_EQ(client.ReadType("error").at("code"), "INVALID_ARGUMENT");
  EXPECT_EQ(backend().requests(), 0u);
}

TEST_F(HostileClientsTest, OversizeMessagesAndBadFramesEndTheirConnection) {
  Start();
  {
    PlainClient client = Connect();
    ASSERT_EQ(client.Upgrade().status, 101);
    client.SendText("{\"type\": \"" + std::string(5000, 'x') + "\"}");
    EXPECT_TRUE(client.WaitForEnd());
  }
  {
    PlainClient client = Connect();
    ASSERT_EQ(client.Upgrade().status, 101);
    client.Send(std::string("\x81\xff\x7f\xff\xff\xff\xff\xff\xff\xff\0\0\0\0", 14));  // 2^63 bytes
    EXPECT_TRUE(client.WaitForEnd());
  }
  {
    PlainClient client = Connect();
    ASSERT_EQ(client.Upgrade().status, 101);
    client.Send(std::string("\x81\x02hi", 4));  // not masked
    EXPECT_TRUE(client.WaitForEnd());
  }
  {
    PlainClient client = Connect();
    ASSERT_EQ(client.Upgrade().status, 101);
    client.SendFrame(1, "\xff\xfe");  // no UTF-8
    EXPECT_TRUE(client.WaitForEnd());
  }
  ExpectAlive();
}

TEST_F(HostileClientsTest, AFloodIsLimitedAndThenLeft) {
  Start();
  PlainClient client = Connect();
  ASSERT_EQ(client.Upgrade().status, 101);
  for (int i = 0; i < 3000; ++i) {
    if (!client.SendText(R"({"type": "strike", "robot": "robot"})")) break;
  }
  EXPECT_TRUE(client.WaitForEnd());
  EXPECT_GE(backend().requests(), 100u);
  EXPECT_LT(backend().requests(), 1000u);
  ExpectAlive();
}

TEST_F(HostileClientsTest, RequestsThatAreNeverAnsweredDoNotPileUp) {
  Start();
  PlainClient client = Connect();
  ASSERT_EQ(client.Upgrade().status, 101);
  for (int i = 0; i < 20; ++i) client.SendText(R"({"type": "list_worlds"})");
  EXPECT_EQ(client.ReadType("reply").at("code"), "RESOURCE_EXHAUSTED");
  EXPECT_EQ(backend().requests(), 8u);
}

TEST_F(HostileClientsTest, WhoSendsSlowlyOrNothingIsLeft) {
  ViewerServerOptions options;
  options.port = 0;
  options.header_timeout_s = 0.3;
  options.silence_timeout_s = 0.3;
  Start(options);
  PlainClient socket = Connect(), silent = Connect(), slow = Connect();
  slow.Send("GET / HTTP/1.1\r\nHost: local");
  ASSERT_EQ(socket.Upgrade().status, 101);
  EXPECT_TRUE(silent.WaitForEnd());
  EXPECT_TRUE(slow.WaitForEnd());
  EXPECT_TRUE(socket.WaitForEnd());  // reads pings, and answers none
}

TEST_F(HostileClientsTest, TwoHundredConnectionsLeaveRoomOnceTheyGo) {
  ViewerServerOptions options;
  options.port = 0;
  options.max_connections = 50;
  options.max_clients = 3;
  Start(options);
  std::vector<std::unique_ptr<PlainClient>> crowd;
  for (int i = 0; i < 200; ++i) {
    crowd.push_back(std::make_unique<PlainClient>(server().port()));
  }
  EXPECT_TRUE(crowd.back()->WaitForEnd());  // there is no room for it
  EXPECT_EQ(crowd.front()->Get("/").status, 200);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(crowd[i]->Upgrade().status, 101);
  EXPECT_EQ(crowd[3]->Upgrade().status, 503);
  for (std::unique_ptr<PlainClient>& client : crowd) {
    client->Send("GET / HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
  }
  crowd.clear();
  // The server sees the ends in its own time.
  for (int i = 0; i < 1000; ++i) {
    if (Connect().Get("/").status == 200) break;
  }
  ExpectAlive();
}

}  // namespace
}  // namespace latticeworld
