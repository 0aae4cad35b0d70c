#include "latticeworld_ros/conversion/agent_markers.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace latticeworld {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

std::vector<Marker> Of(const MarkerArray& array, const std::string& ns) {
  std::vector<Marker> found;
  for (const Marker& marker : array.markers) {
    if (marker.ns == ns && marker.action == Marker::ADD) found.push_back(marker);
  }
  return found;
}

AgentSnapshot Goblin() {
  AgentSnapshot goblin;
  goblin.name = "goblin_1";
  goblin.category = AgentCategory::kGoblin;
  goblin.species = "goblin";
  goblin.team = 2;
  goblin.position_m = {1.0, 2.0, 3.0};
  return goblin;
}

TEST(AgentMarkersTest, ABodyStandsOnItsPlaceAndLiesWhenItFell) {
  const double height_m = SpeciesCatalogue::BuiltIn()->Find("goblin")->height_m;
  WorldState state;
  state.agents = {Goblin()};
  const Marker standing =
      Of(ToMarkerArray(state, Scene(), *SpeciesCatalogue::BuiltIn(), ros::Time(1, 0)), "bodies")
          .at(0);
  EXPECT_EQ(standing.header.frame_id, "map");
  EXPECT_EQ(standing.header.stamp, ros::Time(1, 0));
  EXPECT_NEAR(standing.pose.position.z, 3.0 + height_m / 2.0, 1e-9);
  EXPECT_NEAR(standing.scale.z, height_m, 1e-9);
  // On its face: its height lies along x.
  state.agents[0].orientation = Eigen::AngleAxisd(M_PI / 2.0, Eigen::Vector3d::UnitY());
  const Marker fallen =
      Of(ToMarkerArray(state, Scene(), *SpeciesCatalogue::BuiltIn(), ros::Time(1, 0)), "bodies")
          .at(0);
  EXPECT_NEAR(fallen.pose.position.x, 1.0 + height_m / 2.0, 1e-9);
  EXPECT_NEAR(fallen.pose.position.z, 3.0, 1e-9);
}

TEST(AgentMarkersTest, TheDeadAreFaintAndTeamsHaveColours) {
  WorldState state;
  state.agents = {Goblin(), Goblin()};
  state.agents[1].behaviour = Behaviour::kDead;
  state.agents[1].team = 1;
  const std::vector<Marker> bodies =
      Of(ToMarkerArray(state, Scene(), *SpeciesCatalogue::BuiltIn(), ros::Time(1, 0)), "bodies");
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_LT(bodies[1].color.a, bodies[0].color.a);
  EXPECT_GT(bodies[0].color.r, bodies[0].color.b);
  EXPECT_LT(bodies[1].color.r, bodies[1].color.b);
  EXPECT_NE(bodies[0].id, bodies[1].id);
}

TEST(AgentMarkersTest, AGateIsDrawnFromItsHinge) {
  WorldState state;
  PropSnapshot gate;
  gate.kind = PropKind::kGate;
  gate.size_m = {2.0, 0.1, 1.5};
  state.props = {gate};
  const Marker marker =
      Of(ToMarkerArray(state, Scene(), *SpeciesCatalogue::BuiltIn(), ros::Time(1, 0)), "elements")
          .at(0);
  EXPECT_NEAR(marker.pose.position.x, 1.0, 1e-9);
  EXPECT_NEAR(marker.pose.position.z, 0.75, 1e-9);
}

TEST(AgentMarkersTest, TreesAreDrawnWhileTheyFall) {
  Scene scene;
  scene.assets.resize(2);
  scene.assets[1].half_length_m = 1.5f;
  WorldState state;
  state.felled = {{{0, {0.0, 0.0, 0.0}, {6.0, 0.0, 0.0}}, true},
                  {{1, {0.0, 0.0, 0.0}, {8.0, 0.0, 0.0}}, false}};
  const std::vector<Marker> trees =
      Of(ToMarkerArray(state, scene, *SpeciesCatalogue::BuiltIn(), ros::Time(1, 0)), "trees");
  ASSERT_EQ(trees.size(), 2u);  // stem and crown of the one that falls
  EXPECT_NEAR(trees[0].pose.position.x, 4.0, 1e-9);
  EXPECT_NEAR(trees[0].scale.z, 8.0, 1e-9);
}

}  // namespace
}  // namespace latticeworld
