#include "latticeworld/viewer/server/viewer_server.h"

#include <gtest/gtest.h>

#include <thread>
#include <utility>
#include <vector>

#include "latticeworld/viewer/server/server_messages.h"
#include "viewer/stream_decoder.h"
#include "viewer/viewer_fixture.h"

namespace latticeworld {
namespace {

using nlohmann::json;

StreamFrame FrameOf(StateEncoder* encoder, double time_s, int x_cm, bool key) {
  StreamedThing thing;
  thing.position_cm[0] = x_cm;
  return encoder->Encode(time_s, 1, {thing}, key);
}

TEST_F(ViewerServerTest, ServesThePageAndTheWorldWithTagsAndGzip) {
  Start();
  server().SetWorld(SmallWorld(), "");
  PlainClient client = Connect();
  const PlainResponse page = client.Get("/");
  EXPECT_EQ(page.status, 200);
  EXPECT_EQ(page.body, kPageText);
  EXPECT_EQ(page.headers.at("content-type"), "text/html; charset=utf-8");
  EXPECT_NE(page.headers.at("content-security-policy").find("default-src 'self'"),
            std::string::npos);

  const PlainResponse world = client.Get("/api/world.json");
  ASSERT_EQ(world.status, 200);
  const std::string url = json::parse(world.body).at("payloads").at("height").at("url");
  const PlainResponse height = client.Get(url);
  EXPECT_EQ(height.body.size(), 64u * 64u * 2u);
  EXPECT_NE(height.headers.at("cache-control").find("immutable"), std::string::npos);
  const PlainResponse coded = client.Get("/api/world.json", "Accept-Encoding: br, gzip\r\n");
  ASSERT_EQ(coded.headers.count("content-encoding"), 1u);
  EXPECT_EQ(coded.headers.at("content-encoding"), "gzip");
  EXPECT_LT(coded.body.size(), world.body.size());
  const PlainResponse same =
      client.Get(url, "If-None-Match: " + height.headers.at("etag") + "\r\n");
  EXPECT_EQ(same.status, 304);
  EXPECT_EQ(same.body, "");
}

TEST_F(ViewerServerTest, AHeadHasTheLengthAndNoBody) {
  Start();
  PlainClient client = Connect();
  client.Send("HEAD / HTTP/1.1\r\nHost: localhost\r\n\r\n");
  const PlainResponse head = client.ReadResponse(/*has_body=*/false);
  EXPECT_EQ(head.status, 200);
  EXPECT_EQ(head.headers.at("content-length"), std::to_string(std::string(kPageText).size()));
  EXPECT_EQ(client.Get("/").body, kPageText);  // the connection is where it should be
}

TEST_F(ViewerServerTest, WithoutAWorldSaysSo) {
  Start();
  PlainClient client = Connect();
  EXPECT_EQ(client.Get("/api/world.json").status, 404);
  ASSERT_EQ(client.Upgrade().status, 101);
  EXPECT_TRUE(client.ReadType("hello").at("world").is_null());
}

TEST_F(ViewerServerTest, AJoinerHearsAllThatWasTold) {
  Start();
  server().SetWorld(SmallWorld(), "");
  server().Tell("agents", AgentsMessage(1, {{"robot", "wheeled robot", "", 1, true}}));
  StateEncoder encoder(StreamKind::kAgents);
  server().Show(StreamKind::kAgents, FrameOf(&encoder, 1.0, 100, true));
  server().Show(StreamKind::kAgents, FrameOf(&encoder, 1.1, 150, false));
  PlainClient client = Connect();
  ASSERT_EQ(client.Upgrade().status, 101);
  const json hello = client.ReadType("hello");
  EXPECT_EQ(hello.at("protocol"), 1);
  EXPECT_EQ(hello.at("role"), "controller");  // at the machine itself
  EXPECT_EQ(hello.at("world"), SmallWorld()->key);
  EXPECT_EQ(client.ReadType("agents").at("agents").at(0).at("name"), "robot");
  StreamDecoder decoder;
  ASSERT_TRUE(decoder.Read(ReadBinary(&client)));
  ASSERT_TRUE(decoder.Read(ReadBinary(&client)));
  EXPECT_EQ(decoder.things().at(0).position_cm[0], 150);
  EXPECT_EQ(decoder.time_s(), 1.1);
}

TEST_F(ViewerServerTest, AnotherWorldIsToldAndTheOneBeforeForgotten) {
  Start();
  server().SetWorld(SmallWorld(), "");
  PlainClient client = Connect();
  ASSERT_EQ(client.Upgrade().status, 101);
  client.ReadType("hello");
  server().Tell("weather", "{\"type\": \"weather\"}");
  client.ReadType("weather");
  server().SetWorld(nullptr, "world_server does not run");
  const json told = client.ReadType("world");
  EXPECT_TRUE(told.at("key").is_null());
  EXPECT_EQ(told.at("reason"), "world_server does not run");
  PlainClient later = Connect();
  ASSERT_EQ(later.Upgrade().status, 101);
  later.ReadType("hello");
  server().Tell("clock", "{\"type\": \"clock\"}");
  const json next = later.ReadUntil([](const json&) { return true; });
  EXPECT_EQ(next.at("type"), "clock");  // and no weather before it
}

TEST_F(ViewerServerTest, RequestsReachTheBackendAndAnswersTheirClient) {
  Start();
  PlainClient client = Connect(), other = Connect();
  ASSERT_EQ(client.Upgrade().status, 101);
  ASSERT_EQ(other.Upgrade().status, 101);
  other.ReadType("hello");
  client.SendText(R"({"type": "generate", "layout": "A lake.", "seed": "18446744073709551615",
                      "id": 12})");
  const ViewerRequest request = backend().WaitForRequest();
  EXPECT_EQ(request.layout, "A lake.");
  EXPECT_EQ(request.seed, 18446744073709551615u);
  ViewerReply reply;
  reply.world = "world-1";
  backend().Answer(reply);
  const json answer = client.ReadType("reply");
  EXPECT_EQ(answer.at("id"), 12);
  EXPECT_EQ(answer.at("request"), "generate");
  EXPECT_EQ(answer.at("ok"), true);
  EXPECT_EQ(answer.at("world"), "world-1");
  other.SendText(R"({"type": "subscribe", "layers": []})");
  EXPECT_EQ(other.ReadType("reply").at("request"), "subscribe");  // the other heard no answer
}

TEST_F(ViewerServerTest, WhoComesThroughAProxyThatKeepsTheHostMayOnlyLook) {
  Start();
  for (const char* header :
       {"X-Forwarded-For: 192.0.2.7\r\n", "x-forwarded-for: 127.0.0.1\r\n",
        "Forwarded: for=192.0.2.7;proto=https\r\n", "Via: 1.1 proxy.example\r\n"}) {
    SCOPED_TRACE(header);
    PlainClient client = Connect();
    ASSERT_EQ(client.Upgrade(header, "localhost").status, 101);
    EXPECT_EQ(client.ReadType("hello").at("role"), "viewer");
    client.SendText(R"({"type": "pause", "id": 1})");
    const json answer = client.ReadType("reply");
    EXPECT_EQ(answer.at("ok"), false);
    EXPECT_EQ(answer.at("code"), "PERMISSION_DENIED");
  }
  EXPECT_EQ(backend().requests(), 0u);
  PlainClient here = Connect();
  ASSERT_EQ(here.Upgrade("", "localhost").status, 101);
  EXPECT_EQ(here.ReadType("hello").at("role"), "controller");
}

TEST_F(ViewerServerTest, ABackendThatRefusesIsHeard) {
  Start();
  PlainClient client = Connect();
  ASSERT_EQ(client.Upgrade().status, 101);
  client.SendText(R"({"type": "drive", "robot": "nobody", "linear_mps": 1})");
  EXPECT_EQ(backend().WaitForRequest().robot, "nobody");
  ViewerReply reply;
  reply.status = NotFound("there is no agent \"nobody\"");
  backend().Answer(reply);
  const json answer = client.ReadType("reply");
  EXPECT_EQ(answer.at("code"), "NOT_FOUND");
  EXPECT_EQ(answer.at("ok"), false);
}

TEST_F(ViewerServerTest, LayersAreForThoseWhoLook) {
  Start();
  server().SetWorld(SmallWorld(), "");
  PlainClient looks = Connect(), does_not = Connect();
  ASSERT_EQ(looks.Upgrade().status, 101);
  ASSERT_EQ(does_not.Upgrade().status, 101);
  does_not.ReadType("hello");
  looks.SendText(R"({"type": "subscribe", "layers": ["lidar", "paths"], "robot": "scout"})");
  looks.ReadType("reply");
  EXPECT_EQ(backend().demand().lidar_robots, std::set<std::string>{"scout"});
  EXPECT_TRUE(backend().demand().paths);
  server().ShowPoints("another", "no points");
  server().ShowPoints("scout", "points");
  server().Tell("path:/plan", PathMessage("/plan", {{1, 2, 3}}), Audience::kPaths);
  server().Tell("clock", ClockMessage({}));
  // In either order.
  std::string points, path;
  while (points.empty() || path.empty()) {
    const PlainClient::Message message = looks.ReadMessage();
    ASSERT_NE(message.opcode, 0) << "points: " << points << ", path: " << path;
    if (message.opcode == 2) points = message.payload;
    if (message.payload.find("\"path\"") != std::string::npos) path = message.payload;
  }
  EXPECT_EQ(points, "points");  // and not those of another
  EXPECT_EQ(json::parse(path).at("points_m").at(0).at(1), 2.0);
  EXPECT_EQ(does_not.ReadUntil([](const json&) { return true; }).at("type"), "clock");
  // Once nobody looks any more nobody asks.
  looks.SendText(R"({"type": "subscribe", "layers": []})");
  looks.ReadType("reply");
  EXPECT_TRUE(backend().demand() == LayerDemand());
}

TEST_F(ViewerServerTest, WhoReadsNothingGetsTheNewestLaterAndHoldsUpNobody) {
  Start();
  server().SetWorld(SmallWorld(), "");
  PlainClient slow = Connect(), quick = Connect();
  ASSERT_EQ(slow.Upgrade().status, 101);
  ASSERT_EQ(quick.Upgrade().status, 101);
  slow.ReadType("hello");
  // Far more than the system buffers for a socket: 400 states of a megabyte.
  StateEncoder encoder(StreamKind::kAgents);
  std::vector<StreamedThing> things(45000);
  for (int i = 1; i <= 400; ++i) {
    things.back().position_cm[0] = i;
    server().Show(StreamKind::kAgents, encoder.Encode(i, 1, things, /*key=*/true));
  }
  server().TellOnce("{\"type\": \"last\"}");
  ASSERT_FALSE(quick.ReadType("last").is_null());
  ASSERT_FALSE(slow.ReadType("last").is_null());  // its frames until then are thrown away
  things.back().position_cm[0] = 401;
  server().Show(StreamKind::kAgents, encoder.Encode(401, 1, things, false));
  StreamDecoder decoder;
  int frames = 0;
  for (; frames < 400 && decoder.time_s() != 401.0; ++frames) decoder.Read(ReadBinary(&slow));
  EXPECT_EQ(decoder.things().back().position_cm[0], 401);
  EXPECT_LT(frames, 100);
}

TEST_F(ViewerServerTest, StopsWhateverItsClientsDoAndCanBeginAgain) {
  Start();
  const int port = server().port();
  PlainClient idle = Connect(), half = Connect(), socket = Connect(), waiting = Connect();
  half.Send("GET / HT");
  ASSERT_EQ(socket.Upgrade().status, 101);
  ASSERT_EQ(waiting.Upgrade().status, 101);
  waiting.SendText(R"({"type": "pause"})");
  (void)backend().WaitForRequest();
  server().Stop();
  backend().Answer(ViewerReply());  // comes too late, and to nobody's harm
  server().Tell("clock", "{}");
  End();
  EXPECT_TRUE(idle.WaitForEnd());
  EXPECT_TRUE(half.WaitForEnd());
  EXPECT_TRUE(socket.WaitForEnd());
  ViewerServerOptions options;
  options.port = port;
  Start(options);  // on the same port, at once
  PlainClient again = Connect();
  EXPECT_EQ(again.Get("/").status, 200);
}

TEST_F(ViewerServerTest, APortThatIsTakenIsAFailureThatNamesIt) {
  Start();
  ViewerServerOptions options;
  options.port = server().port();
  const auto second = ViewerServer::Start(options, PageMissing("none"), &backend());
  ASSERT_FALSE(second.ok());
  EXPECT_EQ(second.status().code(), StatusCode::kUnavailable);
  EXPECT_NE(second.status().message().find(std::to_string(options.port)), std::string::npos);
}

TEST_F(ViewerServerTest, IllegalOptionsAreNamedAtOnce) {
  ViewerServerOptions options;
  options.host = "not an address";
  options.port = 70000;
  options.max_clients = 0;
  options.header_timeout_s = -1.0;
  const auto server = ViewerServer::Start(options, PageMissing("none"), &backend());
  ASSERT_FALSE(server.ok());
  EXPECT_EQ(server.status().violations().size(), 4u);
}

}  // namespace
}  // namespace latticeworld
