#include "latticeworld_ros/node/master_state.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace latticeworld {
namespace {

using Names = std::vector<std::string>;

MasterState TwoNodes() {
  MasterState state;
  state.publishers = {{"/clock", {"/world_server"}},
                      {"/map", {"/world_server", "/map_server"}},
                      {"/robot/cmd_vel", {"/teleop", "/navigator"}}};
  state.subscribers = {{"/clock", {"/world_server", "/viewer", "/rviz"}},
                       {"/robot/cmd_vel", {"/world_server"}}};
  state.services = {{"/static_map", {"/map_server"}}, {"/step", {"/world_server"}}};
  return state;
}

TEST(MasterStateTest, IsReadFromWhatTheMasterAnswers) {
  XmlRpc::XmlRpcValue payload;
  payload[0].setSize(0);
  payload[1][0][0] = "/clock";
  payload[1][0][1][0] = "/viewer";
  payload[1][0][1][1] = "/rviz";
  payload[2][0][0] = "/step";
  payload[2][0][1][0] = "/world_server";
  const auto state = MasterStateFrom(payload);
  ASSERT_TRUE(state.has_value());
  EXPECT_TRUE(state->publishers.empty());
  EXPECT_EQ(state->subscribers.at("/clock"), (Names{"/viewer", "/rviz"}));
  EXPECT_EQ(state->services.at("/step"), (Names{"/world_server"}));
  EXPECT_FALSE(MasterStateFrom(XmlRpc::XmlRpcValue("no state")).has_value());
  payload[2][0][0] = 7;
  EXPECT_FALSE(MasterStateFrom(payload).has_value());
}

TEST(MasterStateTest, AServiceIsTakenByAnotherNodeOrGone) {
  const ServiceStanding standing =
      StandingOf(TwoNodes(), "/world_server", {"/step", "/static_map", "/octomap_full"});
  ASSERT_EQ(standing.taken.size(), 1u);
  EXPECT_EQ(standing.taken[0].service, "/static_map");
  EXPECT_EQ(standing.taken[0].node, "/map_server");
  EXPECT_EQ(standing.gone, (Names{"/octomap_full"}));
}

TEST(MasterStateTest, TopicsOfANodeThatAreNotListedWithItAreUnknown) {
  const UnknownTopics unknown = UnknownTo(TwoNodes(), "/world_server", {"/clock", "/agents"},
                                          {"/robot/cmd_vel", "/robot/strike"});
  EXPECT_EQ(unknown.advertised, (Names{"/agents"}));
  EXPECT_EQ(unknown.subscribed, (Names{"/robot/strike"}));
  const UnknownTopics anew = UnknownTo(MasterState(), "/world_server", {"/clock"}, {"/tf"});
  EXPECT_EQ(anew.advertised, (Names{"/clock"}));
  EXPECT_EQ(anew.subscribed, (Names{"/tf"}));
}

TEST(MasterStateTest, ATopicIsNotDeliveredWhereConnectionsAreFewerThanNodesThatWantIt) {
  const auto told = [](std::size_t sent, std::size_t heard) {
    return TopicsNotDelivered(
        TwoNodes(), "/world_server", [sent](const std::string&) { return sent; },
        [heard](const std::string&) { return heard; });
  };
  EXPECT_EQ(told(2, 2), Names());
  EXPECT_EQ(told(1, 2), (Names{"/clock"}));
  EXPECT_EQ(told(2, 1), (Names{"/robot/cmd_vel"}));
  EXPECT_EQ(CountTopics(TwoNodes(), "/world_server"), 4u);
}

}  // namespace
}  // namespace latticeworld
