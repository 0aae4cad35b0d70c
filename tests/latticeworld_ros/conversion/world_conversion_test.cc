#include "latticeworld_ros/conversion/world_conversion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "latticeworld/scene/props/standing_props.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

constexpr double kBed_m = -4.0, kWater_m = -3.0, kDeck_m = 0.5;

// A river 12 m wide from north to south, 1 m deep, and a bridge over it along x.
Scene RiverWithBridge() {
  Scene scene = WithWater(
      MakeScene(128, 64.0, [](double x_m, double) { return std::abs(x_m) < 6.0 ? kBed_m : 0.0; }),
      kWater_m);
  auto terrain = std::make_shared<Terrain>(*scene.terrain);
  Bridge bridge;
  bridge.line = {{-9.0, 0.0}, {9.0, 0.0}};
  bridge.width_m = 5.0;
  bridge.deck_z_m = kDeck_m;
  bridge.thickness_m = 0.4;
  bridge.water_level_m = kWater_m;
  bridge.load_kg = 3500.0;
  bridge.supports_m = {3.0, 15.0};
  terrain->bridges = {bridge};
  terrain->weights.classes.push_back({'G', WeightGrid(128, 128)});
  scene.terrain = terrain;
  return scene;
}

latticeworld_msgs::TerrainSample SampleAt(const Scene& scene, const Atmosphere& atmosphere,
                                          double x_m, double y_m) {
  geometry_msgs::Point point;
  point.x = x_m;
  point.y = y_m;
  const StandingProps props = StandingAtBegin(scene);
  return SampleTerrain(scene, atmosphere, props.decks, {point}).value().front();
}

TEST(WorldConversionTest, ASampleOnADeckTellsBothLevels) {
  const Scene scene = RiverWithBridge();
  const auto sample = SampleAt(scene, scene.atmosphere, 0.0, 1.0);
  EXPECT_NEAR(sample.height, kBed_m, 1e-6);
  EXPECT_NEAR(sample.water_depth, kWater_m - kBed_m, 1e-6);
  EXPECT_NEAR(sample.deck_height, kDeck_m, 1e-9);
  EXPECT_NEAR(sample.deck_clearance, kDeck_m - 0.4 - kWater_m, 1e-6);
  EXPECT_EQ(sample.deck_load, 3500.0);
}

TEST(WorldConversionTest, WhereWaterRisesTheClearanceFalls) {
  const Scene scene = RiverWithBridge();
  Atmosphere flood = scene.atmosphere;
  flood.water_rise_m = 0.3;
  EXPECT_NEAR(SampleAt(scene, flood, 0.0, 1.0).deck_clearance, kDeck_m - 0.4 - kWater_m - 0.3,
              1e-6);
}

TEST(WorldConversionTest, BesideADeckASampleHasNone) {
  const Scene scene = RiverWithBridge();
  const auto sample = SampleAt(scene, scene.atmosphere, 0.0, 4.0);
  EXPECT_TRUE(std::isnan(sample.deck_height));
  EXPECT_TRUE(std::isnan(sample.deck_clearance));
  EXPECT_TRUE(std::isnan(sample.deck_load));
}

}  // namespace
}  // namespace latticeworld
