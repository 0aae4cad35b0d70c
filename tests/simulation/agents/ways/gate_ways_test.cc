#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "latticeworld/scene/props/standing_props.h"
#include "latticeworld/simulation/agents/ways/path_finder.h"
#include "latticeworld/simulation/agents/ways/solid_clearance.h"
#include "latticeworld/simulation/agents/ways/steering.h"
#include "simulation/kinematic_world.h"

namespace latticeworld {
namespace {

constexpr double kGate_m = 3.0;

// A wall along y from -24 to 16 with an opening of the gate's width around y = 0.
TestScene Walled() {
  TestScene scene;
  scene.AddBuilding(0.0, -12.75, 0.4, 11.25);
  scene.AddBuilding(0.0, 8.75, 0.4, 7.25);
  return scene;
}

// Its gate, hinged in the south.
std::shared_ptr<const StandingProps> GateAt(double opening_rad) {
  Prop gate;
  gate.kind = PropKind::kGate;
  gate.size_m = {kGate_m, 0.06, 1.1};
  StandingProps props;
  const Eigen::Quaterniond orientation(
      Eigen::AngleAxisd(M_PI / 2 + opening_rad, Eigen::Vector3d::UnitZ()));
  props.blocks.push_back(*BlockOf(gate, {0.0, -0.5 * kGate_m, 0.0}, orientation));
  return std::make_shared<const StandingProps>(props);
}

Steering Eastwards(Agent* agent, Surroundings* world) {
  return GoTo(agent, world, {15.0, 0.0}, agent->species->cruise_mps);
}

struct Way {
  bool arrived = false;
  double seconds = 0.0;
  double most_y_m = 0.0;
  double least_gap_m = 1e9;  // to the gate's panel
};

// From the west of the wall to its east; the gate opens after that time.
Way Walk(double opens_after_s) {
  const auto scene = Walled().Build();
  KinematicWorld world(scene);
  Agent& goblin = world.Add("goblin", -15.0, 0.0);
  world.changes().props = GateAt(0.0);
  Way way;
  while (way.seconds < 120.0 && !way.arrived) {
    if (world.map_version() == 0 && way.seconds >= opens_after_s) {
      world.changes().props = GateAt(-1.5);
      ++world.map_version();
    }
    world.Run(0.2, Eastwards);
    way.seconds += 0.2;
    way.most_y_m = std::max(way.most_y_m, std::abs(goblin.place().y_m));
    way.least_gap_m = std::min(
        way.least_gap_m, BlockDistance(world.changes().props->blocks[0], scene->terrain->ground,
                                       goblin.place(), goblin.place(), goblin.species->height_m));
    way.arrived = DistanceBetween(goblin.place(), {15.0, 0.0}) < 0.6;
  }
  return way;
}

TEST(GateWaysTest, RoundTheWallWhileItIsClosed) {
  const Way way = Walk(1e9);
  EXPECT_TRUE(way.arrived);
  EXPECT_GT(way.most_y_m, 16.0);
  EXPECT_GT(way.least_gap_m, 0.3);
}

TEST(GateWaysTest, StraightThroughWhereItIsOpen) {
  const Way way = Walk(0.0);
  EXPECT_TRUE(way.arrived);
  EXPECT_LT(way.most_y_m, 3.0);
  EXPECT_GT(way.least_gap_m, 0.3);
}

TEST(GateWaysTest, WhoIsOnTheWayRoundTurnsBackToAGateThatOpens) {
  const Way way = Walk(4.0);
  EXPECT_TRUE(way.arrived);
  EXPECT_LT(way.most_y_m, 12.0);
  EXPECT_LT(way.seconds, Walk(1e9).seconds);
}

TEST(GateWaysTest, WhatHangsTooHighIsInNobodysWay) {
  const auto scene = TestScene().Build();
  SceneChanges changes;
  StandingProps props;
  props.blocks.push_back({{{0.0, 0.0}, 0.3, 0.5, 0.5}, 2.0, 3.0});
  changes.props = std::make_shared<const StandingProps>(props);
  EXPECT_TRUE(IsWayClear(*scene, changes, {-5.0, 0.0}, {5.0, 0.0}, 0.4, 1.2));
  EXPECT_FALSE(IsWayClear(*scene, changes, {-5.0, 0.0}, {5.0, 0.0}, 0.4, 2.4));
  const NearSolids low(*scene, changes, {-1.0, 0.0}, 3.0, 1.2);
  const NearSolids high(*scene, changes, {-1.0, 0.0}, 3.0, 2.4);
  EXPECT_TRUE(low.IsWayClear({-1.0, 0.0}, {1.0, 0.0}, 0.4));
  EXPECT_FALSE(high.IsWayClear({-1.0, 0.0}, {1.0, 0.0}, 0.4));
  EXPECT_TRUE(high.IsWayClear({-1.5, 0.0}, {-1.5, 1.5}, 0.4));
}

}  // namespace
}  // namespace latticeworld
