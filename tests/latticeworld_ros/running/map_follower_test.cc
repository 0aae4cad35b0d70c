#include "latticeworld_ros/running/map_follower.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <thread>

#include "latticeworld_ros/node/step_back.h"

namespace latticeworld {
namespace {

std::shared_ptr<World> WorldNamed(const std::string& id) {
  auto world = std::make_shared<World>();
  world->id = id;
  return world;
}

SceneChanges OneFallenTree() {
  FallenTree tree;
  tree.asset = 3;
  tree.tip_m = {1.0, 2.0, 0.5};
  SceneChanges changes;
  changes.fallen.push_back(tree);
  return changes;
}

PublishedWorld Published(std::shared_ptr<const World> world, SceneChanges changes = {}) {
  PublishedWorld published;
  published.world = std::move(world);
  published.changes = std::move(changes);
  return published;
}

TEST(MapWishTest, IsOpenWhereTheMapsOfItsWorldShowSomethingElse) {
  const auto world = WorldNamed("a");
  const MapWish wish = {world, OneFallenTree(), ros::Time(1.0)};
  const PublishedWorld upright = Published(world), fallen = Published(world, OneFallenTree());
  EXPECT_EQ(StandingOf(wish, &upright), WishStanding::kOpen);
  EXPECT_EQ(StandingOf(wish, &fallen), WishStanding::kDone);
  SceneChanges moved = OneFallenTree();
  moved.fallen[0].tip_m.z() += 0.1;
  const PublishedWorld other = Published(world, moved);
  EXPECT_EQ(StandingOf(wish, &other), WishStanding::kOpen);
}

TEST(MapWishTest, WaitsForItsWorldToBePublished) {
  const auto world = WorldNamed("a"), before = WorldNamed("b");
  const MapWish wish = {world, OneFallenTree(), ros::Time(1.0)};
  const PublishedWorld published = Published(before);
  EXPECT_EQ(StandingOf(wish, nullptr), WishStanding::kWaits);
  EXPECT_EQ(StandingOf(wish, &published), WishStanding::kWaits);
}

TEST(MapWishTest, TellsTwoWorldsOfOneBundleApart) {
  const auto world = WorldNamed("a"), same_bundle = WorldNamed("a");
  const MapWish wish = {world, OneFallenTree(), ros::Time(1.0)};
  const PublishedWorld published = Published(same_bundle);
  EXPECT_EQ(StandingOf(wish, &published), WishStanding::kWaits);
}

TEST(MapWishTest, IsDoneOnceItsWorldIsGone) {
  auto world = WorldNamed("a");
  const MapWish wish = {world, OneFallenTree(), ros::Time(1.0)};
  const PublishedWorld published = Published(WorldNamed("b"));
  world.reset();
  EXPECT_EQ(StandingOf(wish, &published), WishStanding::kDone);
}

// The thread numbers of this process that step back behind the calling one.
std::set<int> ThreadsThatStepBack() {
  const int own = getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
  std::set<int> threads;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task")) {
    const int thread = std::stoi(entry.path().filename().string());
    const bool nicer = getpriority(PRIO_PROCESS, static_cast<id_t>(thread)) > own;
    if (nicer || sched_getscheduler(thread) == SCHED_IDLE) threads.insert(thread);
  }
  return threads;
}

TEST(MapFollowerTest, StepsBackBehindTheSimulation) {
  ASSERT_TRUE(ThreadsThatStepBack().empty());
  const CurrentWorld current;
  const MapFollower follower(WorldServerOptions(), &current, nullptr);
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (ThreadsThatStepBack().empty()) {
    ASSERT_LT(std::chrono::steady_clock::now(), deadline);
    std::this_thread::yield();
  }
}

// Niceness and policy of the calling thread.
std::array<int, 2> Standing() {
  return {getpriority(PRIO_PROCESS, static_cast<id_t>(gettid())), sched_getscheduler(0)};
}

TEST(StepBackTest, GoesNoFurtherBackWhenCalledAgainAndLeavesTheFirstThreadWhereItIs) {
  const std::array<int, 2> first = Standing();
  std::array<int, 2> once{}, twice{};
  std::thread([&once, &twice] {
    StepBack();
    once = Standing();
    StepBack();
    twice = Standing();
  }).join();
  EXPECT_NE(once, first);
  EXPECT_EQ(twice, once);
  EXPECT_EQ(Standing(), first);
}

}  // namespace
}  // namespace latticeworld
