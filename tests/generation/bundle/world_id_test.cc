#include "latticeworld/generation/bundle/world_id.h"

#include <gtest/gtest.h>

#include <functional>

#include "generation/test_world.h"

namespace latticeworld {
namespace {

TEST(WorldIdTest, IsWorldAndTwelveHexDigits) {
  const auto world = MakeTestWorld();
  ASSERT_EQ(world->id.size(), 18u);
  EXPECT_EQ(world->id.substr(0, 6), "world-");
  EXPECT_EQ(world->id.find_first_not_of("0123456789abcdef", 6), std::string::npos);
}

TEST(WorldIdTest, IsTheSameForTheSameContent) {
  EXPECT_EQ(MakeTestWorld()->id, MakeTestWorld()->id);
}

TEST(WorldIdTest, ChangesWithEveryPartOfTheContent) {
  const std::vector<std::function<void(SymbolicLayout*, Terrain*, Scene*)>> changes = {
      [](SymbolicLayout* layout, Terrain*, Scene*) { layout->cells(3, 3) = 'A'; },
      [](SymbolicLayout*, Terrain* terrain, Scene*) {
        Grid<float> height_m = terrain->ground.height_m();
        height_m(63, 63) += 1e-6f;
        terrain->ground = HeightField(terrain->geometry(), height_m);
      },
      [](SymbolicLayout*, Terrain* terrain, Scene*) { terrain->water_level_m(0, 0) = 0.0f; },
      [](SymbolicLayout*, Terrain* terrain, Scene*) {
        terrain->surface(0, 0) = SurfaceClass::kRock;
      },
      [](SymbolicLayout*, Terrain* terrain, Scene*) {
        terrain->weights.classes[0].weight.levels()(0, 0) ^= 1;
      },
      [](SymbolicLayout*, Terrain*, Scene* scene) { scene->environment.agents[0].quantity = 3; },
      [](SymbolicLayout*, Terrain*, Scene* scene) { scene->assets[2].yaw_rad += 0.01f; },
      [](SymbolicLayout*, Terrain*, Scene* scene) { ++scene->assets[2].model; },
      [](SymbolicLayout*, Terrain*, Scene* scene) { scene->assets.pop_back(); },
      [](SymbolicLayout*, Terrain*, Scene* scene) { scene->atmosphere.wind_mps.x() += 0.1; },
      [](SymbolicLayout*, Terrain*, Scene* scene) { scene->atmosphere.intensity += 0.1; },
      [](SymbolicLayout*, Terrain*, Scene* scene) { scene->atmosphere.gust_mps += 0.1; },
      [](SymbolicLayout*, Terrain*, Scene* scene) { scene->atmosphere.hour += 0.1; },
      [](SymbolicLayout*, Terrain*, Scene* scene) { scene->atmosphere.water_rise_m += 0.1; },
      [](SymbolicLayout*, Terrain*, Scene* scene) { scene->agents[0].heading_rad += 0.1; },
      [](SymbolicLayout*, Terrain*, Scene* scene) { scene->props[1].strength *= 2.0; },
      [](SymbolicLayout*, Terrain*, Scene* scene) { scene->agents.pop_back(); },
  };
  const auto world = MakeTestWorld();
  for (std::size_t i = 0; i < changes.size(); ++i) {
    SymbolicLayout layout = world->layout;
    auto terrain = std::make_shared<Terrain>(*world->scene->terrain);
    Scene scene = *world->scene;
    changes[i](&layout, terrain.get(), &scene);
    scene.terrain = terrain;
    EXPECT_NE(ContentId(layout, scene, world->geo), world->id) << "change " << i;
  }
  GeoOrigin elsewhere = *world->geo;
  elsewhere.altitude_m += 1.0;
  EXPECT_NE(ContentId(world->layout, *world->scene, elsewhere), world->id);
  EXPECT_NE(ContentId(world->layout, *world->scene, std::nullopt), world->id);
}

}  // namespace
}  // namespace latticeworld
