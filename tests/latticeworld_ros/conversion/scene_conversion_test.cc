#include "latticeworld_ros/conversion/scene_conversion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace latticeworld {
namespace {

WorldState StateWithAGateAndAFallenTree() {
  WorldState state;
  state.step = 8;
  state.map_version = 2;
  PropSnapshot gate;
  gate.name = "gate_1";
  gate.kind = PropKind::kGate;
  gate.position_m = {1.0, 2.0, 3.0};
  gate.size_m = {2.0, 0.1, 1.5};
  gate.opening_rad = 0.75;
  PropSnapshot post;
  post.name = "post_1";
  post.kind = PropKind::kPost;
  post.broken = true;
  state.props = {gate, post};
  state.felled = {{{17, {1.0, 0.0, 0.0}, {1.0, 9.0, 0.5}}, true}, {{20, {}, {}}, false}};
  return state;
}

TEST(SceneConversionTest, PropsCarryEveryField) {
  const auto message = ToElementStates(StateWithAGateAndAFallenTree(), ros::Time(2, 0), "world-1");
  EXPECT_EQ(message.header.stamp, ros::Time(2, 0));
  EXPECT_EQ(message.header.frame_id, "map");
  EXPECT_EQ(message.world_id, "world-1");
  EXPECT_EQ(message.step, 8u);
  ASSERT_EQ(message.elements.size(), 2u);
  EXPECT_EQ(message.elements[0].name, "gate_1");
  EXPECT_EQ(message.elements[0].kind, "gate");
  EXPECT_EQ(message.elements[0].pose.position.y, 2.0);
  EXPECT_EQ(message.elements[0].pose.orientation.w, 1.0);
  EXPECT_EQ(message.elements[0].size.z, 1.5);
  EXPECT_EQ(message.elements[0].opening, 0.75);
  EXPECT_FALSE(message.elements[0].broken);
  EXPECT_TRUE(message.elements[1].broken);
}

TEST(SceneConversionTest, ChangesTellTreesAndWhatBroke) {
  const auto message =
      ToSceneChangesMessage(StateWithAGateAndAFallenTree(), ros::Time(2, 0), "world-1");
  EXPECT_EQ(message.map_version, 2u);
  ASSERT_EQ(message.felled.size(), 2u);
  EXPECT_EQ(message.felled[0].asset, 17u);
  EXPECT_EQ(message.felled[0].foot.x, 1.0);
  EXPECT_EQ(message.felled[0].tip.y, 9.0);
  EXPECT_TRUE(message.felled[0].at_rest);
  EXPECT_FALSE(message.felled[1].at_rest);
  EXPECT_EQ(message.broken, std::vector<std::string>{"post_1"});
}

TEST(SceneConversionTest, AnPropThatSaysLittleIsAUsualCrate) {
  const auto prop = ToProp(latticeworld_msgs::SpawnElement::Request());
  ASSERT_TRUE(prop.ok()) << prop.status().ToString();
  EXPECT_EQ(prop->kind, PropKind::kCrate);
  EXPECT_GT(prop->size_m.minCoeff(), 0.0);
  EXPECT_GT(prop->mass_kg, 0.0);
}

TEST(SceneConversionTest, WhatIsGivenIsTakenAndTheMassFollowsTheSize) {
  latticeworld_msgs::SpawnElement::Request message;
  message.name = "boulder";
  message.kind = "loose_stone";
  message.position.x = 4.0;
  message.heading = 0.5;
  message.size.x = 0.5;
  const auto small = ToProp(message);
  message.size.x = 1.0;
  const auto large = ToProp(message);
  ASSERT_TRUE(small.ok() && large.ok());
  EXPECT_EQ(small->name, "boulder");
  EXPECT_EQ(small->kind, PropKind::kLooseStone);
  EXPECT_EQ(small->position.x_m, 4.0);
  EXPECT_EQ(small->yaw_rad, 0.5);
  EXPECT_TRUE(small->size_m == Eigen::Vector3d::Constant(0.5));
  EXPECT_NEAR(large->mass_kg / small->mass_kg, 8.0, 1e-9);
  message.mass = 7.0;
  EXPECT_EQ(ToProp(message)->mass_kg, 7.0);
}

TEST(SceneConversionTest, WhatIsIllegalIsCarriedForTheSimulatorToJudge) {
  latticeworld_msgs::SpawnElement::Request message;
  message.name = "no name";
  message.kind = "bridge";
  message.position.x = std::numeric_limits<double>::quiet_NaN();
  message.heading = std::numeric_limits<double>::infinity();
  message.size.z = -1.0;
  message.mass = -2.0;
  message.strength = -3.0;
  const auto prop = ToProp(message);
  ASSERT_TRUE(prop.ok()) << prop.status().ToString();
  EXPECT_EQ(prop->name, "no name");
  EXPECT_TRUE(std::isnan(prop->position.x_m));
  EXPECT_EQ(prop->yaw_rad, std::numeric_limits<double>::infinity());
  EXPECT_EQ(prop->size_m.z(), -1.0);
  EXPECT_EQ(prop->mass_kg, -2.0);
  EXPECT_EQ(prop->strength, -3.0);
}

TEST(SceneConversionTest, WhatIsNoKindOrNoFrameIsRefusedWithAllElseThatIsIllegal) {
  latticeworld_msgs::SpawnElement::Request message;
  message.name = "map";  // its frame would be its own parent
  message.kind = "catapult";
  message.position.x = std::numeric_limits<double>::quiet_NaN();
  message.size.z = 5.0;  // of a bridge it would be legal
  message.mass = std::numeric_limits<double>::infinity();
  const auto prop = ToProp(message);
  ASSERT_FALSE(prop.ok());
  EXPECT_EQ(prop.status().violations().size(), 4u) << prop.status().ToString();
  for (const char* word : {"map", "catapult", "loose stone", "position.x", "mass"}) {
    EXPECT_NE(prop.status().message().find(word), std::string::npos) << word;
  }
}

TEST(SceneConversionTest, GatesOpenWideUnlessTheyAreToldHowFar) {
  latticeworld_msgs::OpenGate::Request message;
  EXPECT_EQ(OpeningOf(message), 1.4);
  message.opening = -0.5;
  EXPECT_EQ(OpeningOf(message), -0.5);
  message.close = true;
  EXPECT_EQ(OpeningOf(message), 0.0);
}

}  // namespace
}  // namespace latticeworld
