#include "latticeworld/viewer/payloads/still_view.h"

#include <gtest/gtest.h>

#include "generation/test_world.h"
#include "latticeworld/generation/world.h"
#include "latticeworld/species/species_catalogue.h"
#include "viewer/stream_decoder.h"
#include "viewer/viewer_fixture.h"

namespace latticeworld {
namespace {

class StillViewTest : public ViewerServerTest {};

TEST_F(StillViewTest, EverythingStandsWhereItBegins) {
  Start();
  const auto world = MakeTestWorld();
  server().SetWorld(SmallWorld(), "");
  ViewerFeed feed(&server());
  ShowStart(*world, *SpeciesCatalogue::BuiltIn(), &feed);
  PlainClient client = Connect();
  ASSERT_EQ(client.Upgrade().status, 101);
  const nlohmann::json agents = client.ReadType("agents").at("agents");
  ASSERT_EQ(agents.size(), 3u);
  EXPECT_EQ(agents.at(0).at("name"), "robot");
  EXPECT_EQ(agents.at(0).at("species"), "wheeled robot");
  EXPECT_EQ(client.ReadType("elements").at("elements").at(1).at("kind"), "post");
  StreamDecoder decoder;
  ASSERT_TRUE(decoder.Read(ReadBinary(&client)));
  ASSERT_EQ(decoder.things().size(), 3u);
  EXPECT_EQ(decoder.things()[0].position_cm[0], -200);
  EXPECT_EQ(decoder.things()[0].position_cm[1], -300);
  const double ground_m = world->scene->terrain->ground.HeightAt({-2.0, -3.0});
  EXPECT_NEAR(decoder.things()[0].position_cm[2] * kStreamStep_m, ground_m + 0.05, 0.0051);
}

TEST(StillBackendTest, RefusesToMoveAnything) {
  StillBackend backend;
  ViewerRequest request;
  request.type = RequestType::kPause;
  ViewerReply answer;
  backend.Do(request, [&answer](const ViewerReply& reply) { answer = reply; });
  EXPECT_EQ(answer.status.code(), StatusCode::kFailedPrecondition);
  EXPECT_NE(answer.status.message().find("world_server"), std::string::npos);
  request.type = RequestType::kListWorlds;
  backend.Do(request, [&answer](const ViewerReply& reply) { answer = reply; });
  EXPECT_TRUE(answer.status.ok());
  EXPECT_TRUE(answer.worlds.has_value());
}

}  // namespace
}  // namespace latticeworld
