#include "latticeworld_ros/server/thing_query.h"

#include <gtest/gtest.h>

#include "latticeworld/common/status.h"

namespace latticeworld {
namespace {

using Request = latticeworld_msgs::QueryThings::Request;
using Response = latticeworld_msgs::QueryThings::Response;

Scene SceneWithACrate() {
  Scene scene;
  Prop crate;
  crate.name = "box";
  crate.position = {3.0, 4.0};
  crate.size_m = {0.5, 0.6, 0.7};
  scene.props = {crate};
  scene.things = {{"box", "crate", 0, -1, {3.0, 4.0}, 0.0}};
  return scene;
}

TEST(ThingQueryTest, TheAnswerHasWhereAPushedCrateIsNow) {
  WorldState state;
  PropSnapshot crate;
  crate.name = "box";
  crate.position_m = {5.0, 4.5, 0.25};
  crate.size_m = {0.5, 0.6, 0.7};
  state.props = {crate};
  Request request;
  request.names = {"box"};
  Response response;
  AnswerQuery(SceneWithACrate(), state, request, &response);
  EXPECT_EQ(response.status.code, static_cast<int>(StatusCode::kOk)) << response.status.message;
  ASSERT_EQ(response.things.size(), 1u);
  EXPECT_EQ(response.things[0].name, "box");
  EXPECT_EQ(response.things[0].kind, "crate");
  EXPECT_EQ(response.things[0].pose.position.x, 5.0);
  EXPECT_EQ(response.things[0].size.y, 0.6);
  EXPECT_EQ(response.things[0].condition, "stands");
}

TEST(ThingQueryTest, UnknownNamesAndTooManyAreRefused) {
  Request request;
  request.names = {"nobody"};
  Response response;
  AnswerQuery(SceneWithACrate(), WorldState(), request, &response);
  EXPECT_EQ(response.status.code, static_cast<int>(StatusCode::kNotFound));
  request.names.assign(kMostQueriedThings + 1, "box");
  AnswerQuery(SceneWithACrate(), WorldState(), request, &response);
  EXPECT_EQ(response.status.code, static_cast<int>(StatusCode::kResourceExhausted));
  EXPECT_TRUE(response.things.empty());
}

}  // namespace
}  // namespace latticeworld
