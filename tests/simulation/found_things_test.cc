#include "latticeworld/simulation/found_things.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "latticeworld/simulation/world_state.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

// A tree that was asked for, and a crate that was, beside a post that was not.
Scene SceneWithThings() {
  TestScene made;
  made.AddTree(10.0, 5.0);
  made.AddProp("box", PropKind::kCrate, -4.0, 2.0);
  made.AddProp("post_1", PropKind::kPost, 0.0, 0.0);
  Scene scene = *made.Build();
  scene.things = {{"big_tree", "oak", 0, 0, {10.0, 5.0}, 0.0},
                  {"box", "crate", 1, -1, {-4.0, 2.0}, 0.0}};
  return scene;
}

PropSnapshot SnapshotOf(const std::string& name, PropKind kind, const Eigen::Vector3d& position_m) {
  PropSnapshot snapshot;
  snapshot.name = name;
  snapshot.kind = kind;
  snapshot.position_m = position_m;
  return snapshot;
}

TEST(FoundThingsTest, WithoutNamesThingsComeFirstAndOtherPropsAfterThem) {
  const auto all = FindThings(SceneWithThings(), nullptr, {});
  ASSERT_TRUE(all.ok());
  ASSERT_EQ(all->size(), 3u);
  EXPECT_EQ((*all)[0].name, "big_tree");
  EXPECT_EQ((*all)[0].kind, "oak");
  EXPECT_FALSE((*all)[0].model.empty());
  EXPECT_EQ((*all)[0].position_m.x(), 10.0);
  EXPECT_GT((*all)[0].size_m.z(), 1.0);
  EXPECT_EQ((*all)[1].name, "box");
  EXPECT_EQ((*all)[2].name, "post_1");
}

TEST(FoundThingsTest, WhatMovedFellBrokeOrWentIsAnsweredAsItIsNow) {
  const Scene scene = SceneWithThings();
  WorldState state;
  state.props = {SnapshotOf("box", PropKind::kCrate, {-1.0, 2.5, 0.1})};
  state.felled = {{{0, {10.0, 5.0, 0.0}, {18.0, 5.0, 0.0}}, true}};
  const auto things = FindThings(scene, &state, {"box", "post_1", "big_tree"});
  ASSERT_TRUE(things.ok()) << things.status().ToString();
  EXPECT_EQ((*things)[0].position_m.x(), -1.0);
  EXPECT_EQ((*things)[0].condition, ThingCondition::kStands);
  EXPECT_EQ((*things)[1].condition, ThingCondition::kGone);
  EXPECT_EQ((*things)[2].condition, ThingCondition::kFelled);
  EXPECT_NEAR(((*things)[2].orientation * Eigen::Vector3d::UnitZ()).x(), 1.0, 1e-9);
  state.props.front().broken = true;
  EXPECT_EQ((*FindThings(scene, &state, {"box"}))[0].condition, ThingCondition::kBroken);
}

TEST(FoundThingsTest, EveryUnknownNameIsTold) {
  const auto things = FindThings(SceneWithThings(), nullptr, {"box", "bax", "nothing"});
  ASSERT_EQ(things.status().code(), StatusCode::kNotFound);
  for (const char* part : {"\"bax\"", "\"nothing\"", "big_tree", "post_1"}) {
    EXPECT_NE(things.status().message().find(part), std::string::npos) << part;
  }
}

}  // namespace
}  // namespace latticeworld
