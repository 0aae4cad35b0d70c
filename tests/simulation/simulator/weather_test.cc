#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/simulation/simulator.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

WeatherChange To(Weather weather, double transition_s = 0.0) {
  WeatherChange change;
  change.weather = weather;
  change.transition_s = transition_s;
  return change;
}

TestScene WithRobot() {
  TestScene scene;
  scene.AddAgent("robot", AgentCategory::kWheeledRobot, 0.0, 0.0);
  return scene;
}

std::vector<Event> WeatherEvents(Simulator* simulator) {
  std::vector<Event> told;
  for (const Event& event : simulator->TakeEvents()) {
    if (event.kind == EventKind::kWeatherChanged) told.push_back(event);
  }
  return told;
}

TEST(WeatherTest, ChangesAtOnceWithoutATransitionAndTellsItOnce) {
  const auto simulator = MakeSimulator(WithRobot());
  RunFor(simulator.get(), 0.05);
  ASSERT_TRUE(simulator->SetWeather(To(Weather::kRain)).ok());
  const auto state = simulator->State();
  EXPECT_EQ(state->atmosphere.weather, Weather::kRain);
  EXPECT_GT(state->atmosphere.rain_mmph, 2.5);
  EXPECT_EQ(state->weather_change_s, 0.0);
  RunFor(simulator.get(), 0.05);
  const auto told = WeatherEvents(simulator.get());
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].agent, "");
  EXPECT_EQ(told[0].other, "rain");
  EXPECT_EQ(told[0].step, 5u);
}

TEST(WeatherTest, MovesOverTheTransitionAndTellsBeginAndEnd) {
  const auto simulator = MakeSimulator(WithRobot());
  const double before_m = simulator->State()->atmosphere.visibility_m;
  ASSERT_TRUE(simulator->SetWeather(To(Weather::kFog, 2.0)).ok());
  EXPECT_EQ(simulator->State()->weather_change_s, 2.0);
  double last_m = before_m;
  for (int i = 0; i < 200; ++i) {
    simulator->Step();
    const double now_m = simulator->State()->atmosphere.visibility_m;
    EXPECT_LT(now_m, last_m);
    last_m = now_m;
  }
  EXPECT_EQ(simulator->State()->weather_change_s, 0.0);
  EXPECT_EQ(last_m, simulator->WeatherTarget().visibility_m);
  RunFor(simulator.get(), 0.1);
  EXPECT_EQ(simulator->State()->atmosphere.visibility_m, last_m);
  const auto told = WeatherEvents(simulator.get());
  ASSERT_EQ(told.size(), 2u);
  EXPECT_EQ(told[0].other, "fog begins");
  EXPECT_EQ(told[0].step, 0u);
  EXPECT_EQ(told[1].other, "fog");
  EXPECT_EQ(told[1].step, 200u);
}

TEST(WeatherTest, AnotherChangeMidwayGoesOnFromThere) {
  const auto simulator = MakeSimulator(WithRobot());
  ASSERT_TRUE(simulator->SetWeather(To(Weather::kSnow, 4.0)).ok());
  RunFor(simulator.get(), 2.0);
  const Atmosphere midway = simulator->State()->atmosphere;
  EXPECT_GT(midway.snow_depth_m, 0.01);
  WeatherChange hour;
  hour.hour = 20.0;
  hour.transition_s = 1.0;
  ASSERT_TRUE(simulator->SetWeather(hour).ok());
  EXPECT_EQ(simulator->State()->atmosphere.snow_depth_m, midway.snow_depth_m);
  RunFor(simulator.get(), 1.0);
  // Where the first change was going to, and the hour as well.
  EXPECT_NEAR(simulator->State()->atmosphere.snow_depth_m, 0.05, 1e-9);
  EXPECT_NEAR(simulator->State()->atmosphere.hour, 20.0, 1e-9);
}

TEST(WeatherTest, AChangeAtOnceMidwayLeavesTheRestOnItsWay) {
  const auto simulator = MakeSimulator(WithRobot());
  ASSERT_TRUE(simulator->SetWeather(To(Weather::kSnow, 4.0)).ok());
  RunFor(simulator.get(), 1.0);
  const Atmosphere midway = simulator->State()->atmosphere;
  WeatherChange hour;
  hour.hour = 20.0;
  ASSERT_TRUE(simulator->SetWeather(hour).ok());
  Atmosphere now = simulator->State()->atmosphere;
  EXPECT_EQ(now.hour, 20.0);
  EXPECT_EQ(now.snow_depth_m, midway.snow_depth_m);
  EXPECT_EQ(now.visibility_m, midway.visibility_m);
  EXPECT_NEAR(simulator->State()->weather_change_s, 3.0, 1e-9);
  RunFor(simulator.get(), 1.0);
  now = simulator->State()->atmosphere;
  EXPECT_EQ(now.hour, 20.0);
  EXPECT_NEAR(now.snow_depth_m, 0.025, 1e-9);  // as if the hour had been left alone
  RunFor(simulator.get(), 2.0);
  EXPECT_EQ(simulator->State()->weather_change_s, 0.0);
  EXPECT_NEAR(simulator->State()->atmosphere.snow_depth_m, 0.05, 1e-9);
  const auto told = WeatherEvents(simulator.get());
  EXPECT_EQ(told.back().other, "snow");
  EXPECT_EQ(told.back().step, 400u);
}

TEST(WeatherTest, AnotherWeatherAtOnceMidwayIsThereWhole) {
  const auto simulator = MakeSimulator(WithRobot());
  ASSERT_TRUE(simulator->SetWeather(To(Weather::kSnow, 4.0)).ok());
  RunFor(simulator.get(), 1.0);
  ASSERT_TRUE(simulator->SetWeather(To(Weather::kRain)).ok());
  EXPECT_EQ(simulator->State()->weather_change_s, 0.0);
  EXPECT_EQ(simulator->State()->atmosphere.snow_depth_m, 0.0);
  EXPECT_EQ(simulator->State()->atmosphere.ground_wetness,
            simulator->WeatherTarget().ground_wetness);
  EXPECT_EQ(WeatherEvents(simulator.get()).back().other, "rain");
  RunFor(simulator.get(), 4.0);
  EXPECT_TRUE(WeatherEvents(simulator.get()).empty());
}

TEST(WeatherTest, WindThatRisesFromACalmBlowsWhereItBlewBefore) {
  TestScene scene = WithRobot();
  scene.atmosphere.wind_mps = {0.0, 4.0, 0.0};
  const auto simulator = MakeSimulator(scene);
  const auto blow = [&simulator](double speed_mps, std::optional<double> heading_rad) {
    WeatherChange change;
    change.wind_speed_mps = speed_mps;
    change.wind_heading_rad = heading_rad;
    EXPECT_TRUE(simulator->SetWeather(change).ok());
    return simulator->State()->atmosphere.wind_mps;
  };
  EXPECT_EQ(blow(0.0, std::nullopt).norm(), 0.0);
  EXPECT_LT((blow(5.0, std::nullopt) - Eigen::Vector3d(0.0, 5.0, 0.0)).norm(), 1e-9);
  // A heading that is said in a calm counts for the next wind, and is part of the state.
  blow(0.0, std::nullopt);
  const std::string hash = simulator->StateHash();
  EXPECT_EQ(blow(0.0, M_PI).norm(), 0.0);
  EXPECT_NE(simulator->StateHash(), hash);
  EXPECT_LT((blow(5.0, std::nullopt) - Eigen::Vector3d(-5.0, 0.0, 0.0)).norm(), 1e-9);
}

TEST(WeatherTest, NothingAskedChangesNothing) {
  const auto simulator = MakeSimulator(WithRobot());
  ASSERT_TRUE(simulator->SetWeather(To(Weather::kRain, 2.0)).ok());
  RunFor(simulator.get(), 1.0);
  simulator->TakeEvents();
  const std::string hash = simulator->StateHash();
  ASSERT_TRUE(simulator->SetWeather({}).ok());
  EXPECT_EQ(simulator->StateHash(), hash);
  EXPECT_TRUE(simulator->TakeEvents().empty());
}

TEST(WeatherTest, IllegalChangesAreRefusedWholeWithEveryViolation) {
  const auto simulator = MakeSimulator(WithRobot());
  const std::string hash = simulator->StateHash();
  WeatherChange change = To(Weather::kRain, -1.0);
  change.intensity = 1.5;
  change.hour = 24.0;
  change.wind_heading_rad = std::nan("");
  const Status status = simulator->SetWeather(change);
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(status.violations().size(), 4u) << status.ToString();
  EXPECT_EQ(simulator->StateHash(), hash);
  EXPECT_TRUE(simulator->TakeEvents().empty());
}

TEST(WeatherTest, SameChangesAtTheSameStepsGiveTheSameRun) {
  TestScene scene = WithRobot();
  scene.height_m = Hills(1.0, 20.0);
  scene.AddAgent("eagle", AgentCategory::kEagle, 8.0, 3.0);
  scene.AddAgent("sheep", AgentCategory::kSheep, -6.0, 4.0);
  const auto run = [&scene](int when, std::uint64_t seed) {
    const auto simulator = MakeSimulator(scene, seed);
    std::vector<std::string> hashes;
    for (int i = 0; i < 300; ++i) {
      if (i == when) {
        EXPECT_TRUE(simulator->SetWeather(To(Weather::kSandstorm, 1.0)).ok());
      }
      EXPECT_TRUE(simulator->Command("robot", Forward(1.0, 0.2)).ok());
      simulator->Step();
      if (i % 50 == 49) hashes.push_back(simulator->StateHash());
    }
    return hashes;
  };
  EXPECT_EQ(run(100, 3), run(100, 3));
  EXPECT_NE(run(100, 3).back(), run(101, 3).back());
  EXPECT_NE(run(100, 3).back(), run(100, 4).back());
}

TEST(WeatherTest, ResetBringsTheScenesWeatherBack) {
  TestScene scene = WithRobot();
  scene.AddAgent("aerial", AgentCategory::kAerialRobot, 5.0, 5.0);
  const auto simulator = MakeSimulator(scene);
  const std::string start = simulator->StateHash();
  ASSERT_TRUE(simulator->SetWeather(To(Weather::kSandstorm, 5.0)).ok());
  EXPECT_NE(simulator->StateHash(), start);
  RunFor(simulator.get(), 3.0);
  simulator->Reset(simulator->seed());
  EXPECT_EQ(simulator->StateHash(), start);
  EXPECT_EQ(simulator->State()->atmosphere.weather, Weather::kSunny);
  EXPECT_EQ(simulator->State()->weather_change_s, 0.0);
}

TEST(WeatherTest, ResetTellsTheWeatherOnlyWhereItWasAnother) {
  for (const double day_length_s : {0.0, 60.0}) {
    SimulatorOptions options;
    options.day_length_s = day_length_s;
    const auto simulator = MakeSimulator(WithRobot(), 1, options);
    EXPECT_TRUE(WeatherEvents(simulator.get()).empty());
    RunFor(simulator.get(), 1.0);
    simulator->Reset(2);
    EXPECT_TRUE(WeatherEvents(simulator.get()).empty());
    for (const double transition_s : {0.0, 5.0}) {
      ASSERT_TRUE(simulator->SetWeather(To(Weather::kFog, transition_s)).ok());
      RunFor(simulator.get(), 1.0);
      simulator->TakeEvents();
      const std::uint64_t step = simulator->State()->step;
      simulator->Reset(2);
      const auto told = WeatherEvents(simulator.get());
      ASSERT_EQ(told.size(), 1u);
      EXPECT_EQ(told[0].other, "sunny");
      EXPECT_EQ(told[0].step, step);
    }
  }
}

TEST(WeatherTest, TheHourGoesRoundWithTheDay) {
  SimulatorOptions options;
  options.day_length_s = 60.0;
  const auto simulator = MakeSimulator(WithRobot(), 1, options);
  const double start_h = simulator->State()->atmosphere.hour;
  RunFor(simulator.get(), 30.0);
  const Atmosphere half = simulator->State()->atmosphere;
  EXPECT_NEAR(std::fmod(half.hour - start_h + 24.0, 24.0), 12.0, 1e-6);
  EXPECT_LT(half.sun_direction.z(), 0.0);
  EXPECT_EQ(half.sun_intensity, 0.0);
  RunFor(simulator.get(), 30.0);
  EXPECT_NEAR(std::remainder(simulator->State()->atmosphere.hour - start_h, 24.0), 0.0, 1e-6);
  options.day_length_s = 5.0;
  EXPECT_EQ(Validate(options).size(), 1u);
}

// How far a robot gets in five seconds at the same command.
double WayOn(SurfaceClass surface, const GroundState& ground) {
  TestScene scene = WithRobot();
  scene.surface = [surface](double, double) { return surface; };
  scene.atmosphere.ground_wetness = ground.wetness;
  scene.atmosphere.snow_depth_m = ground.snow_depth_m;
  const auto simulator = MakeSimulator(scene);
  RunWith(simulator.get(), 5.0, "robot", Forward(1.5));
  return Now(*simulator, "robot").position_m.x();
}

TEST(WeatherTest, SoftGroundAndSnowSlowWheelsDown) {
  const double road_m = WayOn(SurfaceClass::kRoad, {});
  const double field_m = WayOn(SurfaceClass::kFarmland, {});
  const double wet_field_m = WayOn(SurfaceClass::kFarmland, {1.0, 0.0, 0.0});
  const double snow_m = WayOn(SurfaceClass::kGrass, {0.0, 0.2, 0.0});
  EXPECT_GT(road_m, 6.5);
  EXPECT_LT(field_m, road_m - 0.02);
  EXPECT_LT(wet_field_m, field_m - 0.05);
  EXPECT_LT(snow_m, wet_field_m);
  EXPECT_GT(snow_m, 1.0);  // it still gets on
}

// How far a robot goes on after it is told to stop at 2 m/s on a snow field of that material.
double StoppingWayOn(const std::string& material) {
  TestScene scene = WithRobot();
  scene.surface = [](double, double) { return SurfaceClass::kSnow; };
  scene.environment.fine_of(AssetType::kSnowMountain).material = material;
  const auto simulator = MakeSimulator(scene);
  RunWith(simulator.get(), 4.0, "robot", Forward(2.0));
  const double begin_m = Now(*simulator, "robot").position_m.x();
  RunWith(simulator.get(), 4.0, "robot", Forward(0.0));
  const AgentSnapshot end = Now(*simulator, "robot");
  EXPECT_LT(end.linear_velocity_mps.norm(), 0.02);
  return end.position_m.x() - begin_m;
}

TEST(WeatherTest, StoppingTakesLongerOnIceThanOnPackedSnow) {
  EXPECT_GT(StoppingWayOn("ice"), StoppingWayOn("packed snow") + 0.3);
}

TEST(WeatherTest, SnowDuringARunMakesARobotSlideOffItsSlope) {
  TestScene scene = WithRobot();
  scene.height_m = [](double x, double) { return std::tan(20.0 * M_PI / 180.0) * x; };
  const auto simulator = MakeSimulator(scene);
  RunFor(simulator.get(), 3.0);
  const double stood_m = Now(*simulator, "robot").position_m.x();
  RunFor(simulator.get(), 1.0);
  EXPECT_NEAR(Now(*simulator, "robot").position_m.x(), stood_m, 0.01);
  WeatherChange snow;
  snow.snow_depth_m = 0.1;
  ASSERT_TRUE(simulator->SetWeather(snow).ok());
  RunFor(simulator.get(), 2.0);
  EXPECT_LT(Now(*simulator, "robot").position_m.x(), stood_m - 0.3);
}

TEST(WeatherTest, WalkersAreSlowerInDeepSnow) {
  const auto way = [](double snow_depth_m) {
    TestScene scene;
    scene.AddAgent("walker", AgentCategory::kHumanoidRobot, 0.0, 0.0).controllable = true;
    scene.atmosphere.snow_depth_m = snow_depth_m;
    const auto simulator = MakeSimulator(scene);
    RunWith(simulator.get(), 4.0, "walker", Forward(2.0));
    return Now(*simulator, "walker").position_m.x();
  };
  const double bare_m = way(0.0);
  EXPECT_NEAR(way(0.25) / bare_m, 1.0 / std::sqrt(3.3), 0.1);
  EXPECT_LT(way(0.5), way(0.25));
}

// Greatest distance of a hovering robot from where it began.
double BlownOff(double wind_mps, double gust_mps) {
  TestScene scene;
  scene.AddAgent("aerial", AgentCategory::kAerialRobot, 0.0, 0.0).controllable = true;
  scene.atmosphere.wind_mps = {wind_mps, 0.0, 0.0};
  scene.atmosphere.gust_mps = gust_mps;
  const auto simulator = MakeSimulator(scene);
  double farthest_m = 0.0;
  const Eigen::Vector3d begin = Now(*simulator, "aerial").position_m;
  for (int i = 0; i < 800; ++i) {
    simulator->Step();
    farthest_m = std::max(farthest_m, (Now(*simulator, "aerial").position_m - begin).norm());
  }
  return farthest_m;
}

TEST(WeatherTest, WindAndGustsPushFlyers) {
  const double calm_m = BlownOff(0.0, 0.0);
  const double steady_m = BlownOff(10.0, 0.0);
  const double gusty_m = BlownOff(10.0, 8.0);
  EXPECT_LT(calm_m, 0.01);
  EXPECT_GT(steady_m, calm_m + 0.05);
  EXPECT_GT(gusty_m, 1.5 * steady_m);
  EXPECT_LT(gusty_m, 15.0);  // it holds against them
}

TEST(WeatherTest, StormsPushWhatIsLightAndBreezesWakeNobody) {
  const auto pushed = [](AgentCategory category, double wind_mps) {
    TestScene scene;
    scene.AddAgent("it", category, 0.0, 0.0).controllable = true;
    scene.surface = [](double, double) { return SurfaceClass::kSnow; };
    scene.atmosphere.wind_mps = {wind_mps, 0.0, 0.0};
    const auto simulator = MakeSimulator(scene);
    RunFor(simulator.get(), 3.0);
    return Now(*simulator, "it").position_m.x();
  };
  EXPECT_NEAR(pushed(AgentCategory::kHumanoidRobot, 5.0), 0.0, 0.01);
  EXPECT_GT(pushed(AgentCategory::kHumanoidRobot, 35.0), 0.3);
  EXPECT_NEAR(pushed(AgentCategory::kHorse, 20.0), 0.0, 0.02);
}

TEST(WeatherTest, WhaleSinksAndRisesWithItsWater) {
  TestScene scene;
  scene.height_m = [](double, double) { return -6.0; };
  scene.water_depth_m = [](double, double) { return 6.0; };
  scene.AddAgent("whale", AgentCategory::kWhale, 0.0, 0.0);
  const auto height_after = [&scene](double rise_m) {
    const auto simulator = MakeSimulator(scene);
    WeatherChange change;
    change.water_rise_m = rise_m;
    EXPECT_TRUE(simulator->SetWeather(change).ok());
    RunFor(simulator.get(), 20.0);
    return Now(*simulator, "whale").position_m.z();
  };
  const double mean_m = height_after(0.0);
  EXPECT_GT(height_after(2.0), mean_m + 0.5);
  EXPECT_LT(height_after(-3.0), mean_m - 0.5);
}

TEST(WeatherTest, WalkersDoNotFordWhatHasRisen) {
  // A shallow river between a goblin and the robot that it hunts.
  TestScene scene;
  scene.water_depth_m = [](double x, double) { return x > 3.0 && x < 13.0 ? 0.3 : 0.0; };
  scene.AddAgent("robot", AgentCategory::kWheeledRobot, 16.0, 0.0);
  scene.AddAgent("goblin", AgentCategory::kGoblin, 0.0, 0.0);
  const auto crossed = [&scene](double rise_m) {
    const auto simulator = MakeSimulator(scene);
    WeatherChange change;
    change.water_rise_m = rise_m;
    EXPECT_TRUE(simulator->SetWeather(change).ok());
    RunFor(simulator.get(), 15.0);
    return Now(*simulator, "goblin").position_m.x() > 13.0;
  };
  EXPECT_TRUE(crossed(0.0));
  EXPECT_FALSE(crossed(0.5));
}

TEST(WeatherTest, WalkersKeepOffSlopesThatSnowMakesTooSlippery) {
  // A ramp of 25 degrees between a goblin and what it hunts, which hovers over the far end.
  TestScene scene;
  scene.height_m = [](double x, double) {
    return std::clamp(x - 2.0, 0.0, 10.0) * std::tan(25.0 * M_PI / 180.0);
  };
  AgentStart& prey = scene.AddAgent("prey", AgentCategory::kAerialRobot, 15.0, 0.0);
  prey.controllable = true;
  prey.team = 1;
  scene.AddAgent("goblin", AgentCategory::kGoblin, -2.0, 0.0);
  const auto farthest = [&scene](double snow_depth_m) {
    const auto simulator = MakeSimulator(scene);
    WeatherChange change;
    change.snow_depth_m = snow_depth_m;
    EXPECT_TRUE(simulator->SetWeather(change).ok());
    double x_m = -2.0;
    for (int i = 0; i < 2000 && x_m < 12.5; ++i) {
      simulator->Step();
      x_m = std::max(x_m, Now(*simulator, "goblin").position_m.x());
    }
    return x_m;
  };
  EXPECT_GT(farthest(0.0), 12.0);
  EXPECT_LT(farthest(0.1), 6.0);
}

TEST(WeatherTest, FogDuringARunHidesTheRobot) {
  TestScene scene = WithRobot();
  scene.AddAgent("goblin", AgentCategory::kGoblin, 20.0, 0.0).heading_rad = M_PI;
  const auto pursued = [&scene](double visibility_m) {
    const auto simulator = MakeSimulator(scene);
    WeatherChange change;
    change.visibility_m = visibility_m;
    EXPECT_TRUE(simulator->SetWeather(change).ok());
    RunFor(simulator.get(), 1.0);
    return Count(simulator->TakeEvents(), EventKind::kPursued, "goblin") > 0;
  };
  EXPECT_TRUE(pursued(10000.0));
  EXPECT_FALSE(pursued(10.0));
}

}  // namespace
}  // namespace latticeworld
