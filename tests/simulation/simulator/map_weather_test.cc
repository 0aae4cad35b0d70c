// Weather changes what the ground holds, and maps follow it.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "latticeworld/mapping/traversability.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld/species/species_catalogue.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

TestScene Slope(double slope_rad) {
  TestScene scene;
  scene.height_m = [slope_rad](double x, double) { return std::tan(slope_rad) * x; };
  scene.AddAgent("robot", AgentCategory::kWheeledRobot, 0.0, 0.0);
  return scene;
}

WeatherChange Snow(double depth_m, double transition_s) {
  WeatherChange change;
  change.snow_depth_m = depth_m;
  change.transition_s = transition_s;
  return change;
}

TEST(MapWeatherTest, MapsFollowInStepsAndEndWithTheWeather) {
  const auto simulator = MakeSimulator(Slope(0.0));
  ASSERT_TRUE(simulator->SetWeather(Snow(0.4, 4.0)).ok());
  RunFor(simulator.get(), 3.9);
  EXPECT_GE(simulator->State()->map_version, 3u);
  RunFor(simulator.get(), 0.2);
  const std::uint64_t end = simulator->State()->map_version;
  EXPECT_LE(end, 40u);
  EXPECT_EQ(ChangesOf(*simulator->State()).ground, simulator->State()->atmosphere.ground());
  RunFor(simulator.get(), 2.0);
  EXPECT_EQ(simulator->State()->map_version, end);
  // As it was in the beginning: nothing has changed since then.
  ASSERT_TRUE(simulator->SetWeather(Snow(0.0, 0.0)).ok());
  EXPECT_GT(simulator->State()->map_version, end);
  EXPECT_EQ(ChangesOf(*simulator->State()).ground, std::nullopt);
}

TEST(MapWeatherTest, WeatherThatLeavesTheGroundLeavesTheMaps) {
  const auto simulator = MakeSimulator(Slope(0.0));
  WeatherChange wind;
  wind.wind_speed_mps = 9.0;
  wind.transition_s = 1.0;
  ASSERT_TRUE(simulator->SetWeather(wind).ok());
  RunFor(simulator.get(), 1.5);
  EXPECT_EQ(simulator->State()->map_version, 0u);
  EXPECT_EQ(ChangesOf(*simulator->State()).ground, std::nullopt);
}

TEST(MapWeatherTest, ASnapshotHoldsWhatMapsShow) {
  const auto simulator = MakeSimulator(Slope(0.1));
  ASSERT_TRUE(simulator->SetWeather(Snow(0.4, 4.0)).ok());
  RunFor(simulator.get(), 2.0);
  const auto snapshot = simulator->Save();
  const SceneChanges then = ChangesOf(*simulator->State());
  ASSERT_TRUE(then.ground.has_value());
  RunFor(simulator.get(), 3.0);
  const std::string hash = simulator->StateHash();
  ASSERT_TRUE(simulator->Restore(*snapshot).ok());
  EXPECT_EQ(ChangesOf(*simulator->State()), then);
  RunFor(simulator.get(), 3.0);
  EXPECT_EQ(simulator->StateHash(), hash);
  simulator->Reset(1);
  EXPECT_EQ(ChangesOf(*simulator->State()).ground, std::nullopt);
}

// Way up the slope [m] in six seconds at 0.8 m/s.
double WayUp(double slope_rad, const GroundState& ground) {
  TestScene scene = Slope(slope_rad);
  scene.atmosphere.ground_wetness = ground.wetness;
  scene.atmosphere.snow_depth_m = ground.snow_depth_m;
  const auto simulator = MakeSimulator(scene);
  RunFor(simulator.get(), 0.5);
  const double begin_m = Now(*simulator, "robot").position_m.x();
  RunWith(simulator.get(), 6.0, "robot", Forward(0.8));
  return Now(*simulator, "robot").position_m.x() - begin_m;
}

TEST(MapWeatherTest, ARobotClimbsWhatTheMapLeavesOpenAndNotWhatItCloses) {
  const Species& robot = *SpeciesCatalogue::BuiltIn()->Find("wheeled robot");
  RobotLimits limits;
  limits.max_slope_rad = robot.max_slope_rad;
  limits.grip = robot.grip;
  for (const GroundState& ground :
       {GroundState{0.0, 0.03, 0.0}, GroundState{0.0, 0.3, 0.0}, GroundState{1.0, 0.0, 0.0}}) {
    const double holds_rad = ClimbableSlope(
        Weathered(SurfaceClass::kGrass, DryPropertiesOf(SurfaceClass::kGrass), ground), robot.grip,
        true);
    SCOPED_TRACE(testing::Message() << "wetness " << ground.wetness << ", snow "
                                    << ground.snow_depth_m << " m: holds " << holds_rad << " rad");
    SceneChanges changes;
    changes.ground = ground;
    const auto cost = [&](double slope_rad) {
      return BuildOccupancy(*Slope(slope_rad).Build(), limits, changes)(64, 20);
    };
    EXPECT_LT(cost(0.8 * holds_rad), 100);
    EXPECT_GT(WayUp(0.8 * holds_rad, ground), 2.0);
    EXPECT_EQ(cost(1.25 * holds_rad), 100);
    EXPECT_LT(WayUp(1.25 * holds_rad, ground), 0.5);
  }
}

}  // namespace
}  // namespace latticeworld
