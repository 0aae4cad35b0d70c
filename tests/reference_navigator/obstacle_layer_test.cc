#include "latticeworld/reference_navigator/obstacle_layer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

// Ground and posts that rays are marched through.
struct Land {
  std::function<double(double x_m, double y_m)> ground = [](double, double) { return 0.0; };
  struct Post {
    double x_m, y_m, radius_m, low_m, high_m;  // heights above 0
  };
  std::vector<Post> posts;

  bool Solid(const Eigen::Vector3d& at) const {
    if (at.z() <= ground(at.x(), at.y())) return true;
    for (const Post& post : posts) {
      if (std::hypot(at.x() - post.x_m, at.y() - post.y_m) <= post.radius_m &&
          at.z() >= post.low_m && at.z() <= post.high_m)
        return true;
    }
    return false;
  }

  // From half a metre above the origin; of one elevation it is a planar scan.
  SensorSighting Sweep(const std::vector<double>& elevations, double time_s) const {
    SensorSighting sighting;
    sighting.time_s = time_s;
    sighting.map_from_sensor.translation().z() = 0.5;
    sighting.planar = elevations.size() == 1;
    constexpr double kFar_m = 10.0, kPiece_m = 0.04;
    constexpr int kRays = 540;
    for (const double elevation : elevations) {
      for (int i = 0; i < kRays; ++i) {
        const double azimuth = 2.0 * M_PI * i / kRays;
        const Eigen::Vector3d way(std::cos(elevation) * std::cos(azimuth),
                                  std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
        double far_m = 0.3;
        while (far_m < kFar_m && !Solid(sighting.map_from_sensor * (far_m * way)))
          far_m += kPiece_m;
        auto& ends = far_m < kFar_m ? sighting.hits_m : sighting.misses_m;
        ends.push_back((far_m * way).cast<float>());
      }
    }
    return sighting;
  }
};

class ObstacleLayerTest : public testing::TestWithParam<bool> {  // whether the sensor is of 3D
 protected:
  ObstacleLayerTest() { layer_.MoveTo(Eigen::Vector3d::Zero()); }
  void See(const Land& land, double time_s) {
    std::vector<double> elevations = {0.0};
    if (GetParam())
      for (int i = -24; i <= 6; ++i) elevations.push_back(0.02 * i);
    layer_.See(land.Sweep(elevations, time_s), nullptr);
    layer_.Settle(time_s);
  }
  NavigatorOptions options_;
  ObstacleLayer layer_{options_};
};

TEST_P(ObstacleLayerTest, HoldsWhatStandsAndNothingElse) {
  Land land;
  land.posts = {{3.0, 1.0, 0.2, 0.0, 1.5}};
  See(land, 0.0);
  EXPECT_LT(layer_.DistanceAt({2.8, 0.95}), 0.2);
  EXPECT_NEAR(layer_.DistanceAt({2.8, 0.4}), 0.45, 0.2);
  EXPECT_GT(layer_.DistanceAt({-3.0, 0.0}), 1.9);
  EXPECT_GT(layer_.DistanceAt({1.0, 0.0}), 1.8);
}

TEST_P(ObstacleLayerTest, WhatMovesLeavesNoTrail) {
  Land land;
  for (int i = 0; i <= 20; ++i) {
    land.posts = {{3.0, -3.0 + 0.3 * i, 0.3, 0.0, 1.5}};
    See(land, 0.1 * i);
  }
  EXPECT_LT(layer_.DistanceAt({2.8, 2.95}), 0.3);
  for (double y_m = -3.0; y_m < 1.4; y_m += 0.2)
    EXPECT_GT(layer_.DistanceAt({2.8, y_m}), 0.4) << "at " << y_m;
}

TEST_P(ObstacleLayerTest, KeepsWhatIsHiddenUntilItsTimeIsOver) {
  Land land;
  land.posts = {{4.0, 0.0, 0.2, 0.0, 1.5}};
  See(land, 0.0);
  land.posts = {{2.0, 0.0, 0.4, 0.0, 3.0}};  // before it
  for (int i = 1; i < 4; ++i) See(land, 0.1 * i);
  EXPECT_LT(layer_.DistanceAt({3.8, 0.0}), 0.2);
  layer_.Settle(options_.memory_s - 0.5);
  EXPECT_LT(layer_.DistanceAt({3.8, 0.0}), 0.2);
  layer_.Settle(options_.memory_s + 0.05);
  EXPECT_GT(layer_.DistanceAt({3.8, 0.0}), 0.5);
}

TEST_P(ObstacleLayerTest, MovesWithTheRobotAndKeepsPlaces) {
  Land land;
  land.posts = {{3.0, 1.0, 0.2, 0.0, 1.5}};
  See(land, 0.0);
  layer_.MoveTo({9.0, -2.0, 0.0});
  layer_.Settle(0.1);
  EXPECT_LT(layer_.DistanceAt({2.8, 0.95}), 0.2);
  layer_.MoveTo({60.0, 0.0, 0.0});
  layer_.MoveTo({0.0, 0.0, 0.0});
  layer_.Settle(0.2);
  EXPECT_GT(layer_.DistanceAt({2.8, 0.95}), 1.9) << "what left the window is forgotten";
}

INSTANTIATE_TEST_SUITE_P(Sensors, ObstacleLayerTest, testing::Bool());

TEST(ObstacleLayerSnowTest, FlakesAreNoObstaclesAndThePostAmongThemIsOne) {
  ObstacleLayer layer{NavigatorOptions()};
  layer.MoveTo(Eigen::Vector3d::Zero());
  Land land;
  land.posts = {{0.0, 2.0, 0.15, 0.0, 1.5}};
  RandomStream random(1, "flakes");
  int wrong = 0;
  for (int i = 0; i < 100; ++i) {
    SensorSighting scan = land.Sweep({0.0}, 0.1 * i);
    for (int flake = 0; flake < 8; ++flake) {
      const double azimuth = random.Uniform(0.0, 2.0 * M_PI), far_m = random.Uniform(0.5, 3.0);
      scan.hits_m.emplace_back(static_cast<float>(far_m * std::cos(azimuth)),
                               static_cast<float>(far_m * std::sin(azimuth)), 0.0f);
    }
    layer.See(scan, nullptr);
    layer.Settle(0.1 * i);
    EXPECT_LT(layer.DistanceAt({0.0, 1.8}), 0.2);
    // Within half a metre of a way that leads away from the post.
    for (double x_m = 0.5; x_m < 3.0; x_m += 0.25) wrong += layer.DistanceAt({x_m, -1.0}) < 0.5;
  }
  EXPECT_LT(wrong, 60) << "of 1000 looks";
}

TEST(ObstacleLayerBadInputTest, PointsThatAreNoNumbersAreLeftOut) {
  ObstacleLayer layer{NavigatorOptions()};
  layer.MoveTo(Eigen::Vector3d::Zero());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  for (const bool planar : {false, true}) {
    SensorSighting sighting;
    sighting.planar = planar;
    for (int i = 0; i < 5; ++i) {
      sighting.hits_m.insert(sighting.hits_m.end(), {{nan, 0, 0}, {inf, 1, 1}, {1e30f, 0, 0}});
      sighting.misses_m.emplace_back(inf, 0.0f, 0.0f);
    }
    layer.See(sighting, nullptr);
    layer.Settle(0.0);
  }
  for (double x_m = -10.0; x_m < 10.0; x_m += 0.5) EXPECT_GT(layer.DistanceAt({x_m, 0.0}), 1.9);
}

}  // namespace
}  // namespace latticeworld
