#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>

#include "latticeworld/sensing/solids/ray_scene.h"
#include "latticeworld/terrain/terrain.h"
#include "simulation/test_scene.h"
#include "terrain/gorge_bridge.h"

namespace latticeworld {
namespace {

constexpr double kHalfGorge_m = 10.0, kBed_m = -5.0;

// A dry gorge from north to south, and the bridge of a road over it along x with a pier in its
// middle.
std::shared_ptr<const Scene> Gorge() {
  TestScene made;
  made.cells = 256;
  made.height_m = [](double x, double) { return std::abs(x) < kHalfGorge_m ? kBed_m : 0.0; };
  auto scene = std::make_shared<Scene>(*made.Build());
  auto terrain = std::make_shared<Terrain>(*scene->terrain);
  terrain->bridges = {BridgeOverGorge(13.0, kBed_m, 40e3)};
  scene->terrain = std::move(terrain);
  return scene;
}

// A wheeled robot that starts there, after so long at 1 m/s straight on.
AgentSnapshot Driven(double x_m, double y_m, double heading_rad, double seconds) {
  auto simulator = Simulator::Create(Gorge(), SimulatorOptions(), 1).value();
  SpawnRequest request = RequestFor("wheeled robot", "rover", x_m, y_m);
  request.controllable = true;
  request.heading_rad = heading_rad;
  MustSpawn(simulator.get(), request);
  RunWith(simulator.get(), seconds, "rover", Forward(1.0));
  return Now(*simulator, "rover");
}

TEST(RoadBridgeTest, ARobotDrivesOverIt) {
  const AgentSnapshot rover = Driven(-16.0, 0.0, 0.0, 32.0);
  EXPECT_GT(rover.position_m.x(), 13.5);
  EXPECT_NEAR(rover.position_m.z(), 0.0, 0.1);
}

TEST(RoadBridgeTest, ARobotPassesBelowIt) {
  const AgentSnapshot rover = Driven(5.0, -8.0, M_PI_2, 17.0);
  EXPECT_GT(rover.position_m.y(), 6.0);
  EXPECT_NEAR(rover.position_m.z(), kBed_m, 0.1);
}

TEST(RoadBridgeTest, ItsPierStopsARobotBelow) {
  const AgentSnapshot rover = Driven(0.0, -8.0, M_PI_2, 17.0);
  EXPECT_LT(rover.position_m.y(), -2.0);
  EXPECT_GT(rover.position_m.y(), -4.0);
}

TEST(RoadBridgeTest, ItsRailingKeepsARobotOnTheDeck) {
  const AgentSnapshot rover = Driven(-16.0, 0.0, 0.25, 20.0);
  EXPECT_GT(rover.position_m.x(), -9.0);
  EXPECT_NEAR(rover.position_m.z(), 0.0, 0.15);
  EXPECT_LT(rover.position_m.y(), 2.5);
}

TEST(RoadBridgeTest, RaysMeetItFromAboveAndFromBelow) {
  const std::shared_ptr<const Scene> scene = Gorge();
  const RayScene rays = RayScene::Create(*scene, RaySceneOptions(), Progress()).value();
  Ray down;
  down.origin_m = {5.0f, 0.0f, 10.0f};
  down.direction = {0.0f, 0.0f, -1.0f};
  const RayHit deck = rays.Trace(down, kSeesAll);
  EXPECT_EQ(deck.target, RayTarget::kBridge);
  EXPECT_EQ(deck.part, static_cast<std::uint8_t>(BridgePartKind::kDeck));
  EXPECT_NEAR(deck.distance_m, 9.99f, 1e-3f);
  Ray up = down;
  up.origin_m = {5.0f, 0.0f, -4.0f};
  up.direction = {0.0f, 0.0f, 1.0f};
  EXPECT_NEAR(rays.Trace(up, kSeesAll).distance_m, 4.0f - 0.39f, 1e-3f);
  EXPECT_TRUE(rays.IsBlocked(up, kSeesSolid));
  // Along the gorge there is nothing between the pier and the wall.
  Ray along = down;
  along.origin_m = {5.0f, -8.0f, -3.0f};
  along.direction = {0.0f, 1.0f, 0.0f};
  along.to_m = 16.0f;
  EXPECT_EQ(rays.Trace(along, kSeesAll).target, RayTarget::kNothing);
  along.origin_m.x() = 0.0f;
  EXPECT_EQ(rays.Trace(along, kSeesAll).part, static_cast<std::uint8_t>(BridgePartKind::kPier));
}

}  // namespace
}  // namespace latticeworld
