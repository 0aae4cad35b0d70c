#include "latticeworld/learning/robot_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace latticeworld {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();

std::vector<float> Sectors(const std::vector<float>& ranges_m, int sectors) {
  LidarSweep sweep;
  sweep.ranges_m = ranges_m;
  std::vector<float> found(static_cast<std::size_t>(sectors), -1.0f);
  NearestInSectors(&sweep, 0.5, sectors, 9.0f, found.data());
  return found;
}

TEST(RobotViewTest, EachSectorHasItsNearestReturn) {
  EXPECT_EQ(Sectors({3, 2, 5, 4, 8, 7}, 3), (std::vector<float>{2, 4, 7}));
  EXPECT_EQ(Sectors({3, 2, 5, 4, 8}, 2), (std::vector<float>{2, 4}));  // 2 beams and 3
  EXPECT_EQ(Sectors({3, 2}, 1), (std::vector<float>{2}));
}

TEST(RobotViewTest, WithMoreSectorsThanBeamsEachTakesOne) {
  EXPECT_EQ(Sectors({3, 2}, 4), (std::vector<float>{3, 3, 2, 2}));
}

TEST(RobotViewTest, WhatGaveNoRangeIsAsFarAsCanBe) {
  EXPECT_EQ(Sectors({std::nanf(""), kInf, -kInf, 0.4f, 20.0f, 3.0f}, 3),
            (std::vector<float>{9, 9, 3}));
  std::vector<float> found(2, 0.0f);
  NearestInSectors(nullptr, 0.5, 2, 9.0f, found.data());
  EXPECT_EQ(found, (std::vector<float>{9, 9}));
}

TEST(RobotViewTest, SpeedsAreTheBodysAndYawIsTheMaps) {
  AgentSnapshot agent;
  agent.orientation = Eigen::AngleAxisd(2.5, Eigen::Vector3d::UnitZ());
  agent.linear_velocity_mps = {1.0, 0.2, 0.1};
  agent.angular_velocity_radps = {0.1, 0.2, 0.3};
  agent.behaviour = Behaviour::kDead;
  const RobotView view = ViewOf(agent);
  EXPECT_NEAR(view.yaw_rad, 2.5, 1e-12);
  EXPECT_EQ(view.forward_mps, 1.0);
  EXPECT_EQ(view.yaw_rate_radps, 0.3);
  EXPECT_EQ(view.alive, 0.0);
}

}  // namespace
}  // namespace latticeworld
