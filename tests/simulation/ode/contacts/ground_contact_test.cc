#include "latticeworld/simulation/ode/contacts/ground_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

HeightField Ground(const std::function<double(double, double)>& height_m) {
  TestScene scene;
  scene.height_m = height_m;
  return scene.Build()->terrain->ground;
}

TEST(GroundContactTest, BallOnARampTouchesAlongItsNormal) {
  const double slope_rad = 0.4;
  const HeightField ground = Ground([&](double x, double) { return std::tan(slope_rad) * x; });
  const Eigen::Vector3d normal(-std::sin(slope_rad), 0.0, std::cos(slope_rad));
  const Eigen::Vector3d on_ground(2.0, 1.0, 2.0 * std::tan(slope_rad));
  const GroundContacts touch = TouchGround(ground, on_ground + 0.28 * normal, 0.3);
  ASSERT_EQ(touch.count, 1);
  EXPECT_NEAR(touch.contact[0].depth_m, 0.02, 1e-5);
  EXPECT_LT((touch.contact[0].normal - normal).norm(), 1e-5);
  EXPECT_EQ(TouchGround(ground, on_ground + 0.31 * normal, 0.3).count, 0);
}

TEST(GroundContactTest, BallInAFoldTouchesBothSides) {
  const HeightField ground = Ground([](double x, double) { return std::abs(x + 0.25); });
  const GroundContacts touch = TouchGround(ground, {-0.25, 0.0, 0.4}, 0.3);
  ASSERT_EQ(touch.count, 2);
  EXPECT_LT(touch.contact[0].normal.x() * touch.contact[1].normal.x(), 0.0);
}

TEST(GroundContactTest, BallOverACrestTouchesTheCrestAlone) {
  const HeightField ground = Ground([](double x, double) { return -std::abs(x + 0.25); });
  const GroundContacts touch = TouchGround(ground, {-0.25, 0.0, 0.29}, 0.3);
  ASSERT_EQ(touch.count, 1);
  EXPECT_NEAR(touch.contact[0].normal.z(), 1.0, 1e-9);
  EXPECT_NEAR(touch.contact[0].depth_m, 0.01, 1e-6);
}

// Small balls mostly stand over one triangle, which they touch at the distance to its plane.
TEST(GroundContactTest, DepthIsThatBelowThePlaneOfTheTriangle) {
  const HeightField ground = Ground(Hills(2.0, 12.0));
  RandomStream random(4, "balls");
  for (int i = 0; i < 2000; ++i) {
    const WorldPoint at{random.Uniform(-31.0, 31.0), random.Uniform(-31.0, 31.0)};
    const Eigen::Vector3d normal = ground.NormalAt(at);
    const Eigen::Vector3d on_ground(at.x_m, at.y_m, ground.HeightAt(at));
    const double radius_m = 0.02;
    const GroundContacts ball = TouchGround(ground, on_ground + 0.015 * normal, radius_m);
    ASSERT_GE(ball.count, 1);
    double depth_m = 0.0;
    for (int k = 0; k < ball.count; ++k) {
      depth_m = std::max(depth_m, ball.contact[static_cast<std::size_t>(k)].depth_m);
    }
    EXPECT_GT(depth_m, 0.004);  // at a crease less than below the plane
    EXPECT_EQ(TouchGround(ground, on_ground + 0.2 * normal, radius_m).count, 0);
    const Eigen::Vector3d below = on_ground - Eigen::Vector3d(0.0, 0.0, 0.01);
    const GroundContacts point = TouchGround(ground, below, 0.0);
    ASSERT_EQ(point.count, 1);
    EXPECT_NEAR(point.contact[0].depth_m, 0.01 * normal.z(), 1e-9);
    EXPECT_EQ(point.contact[0].normal, normal);
  }
}

TEST(GroundContactTest, NoBallBelowTheGroundIsOverlooked) {
  const HeightField ground = Ground(Hills(2.0, 12.0));
  RandomStream random(3, "balls");
  for (int i = 0; i < 5000; ++i) {
    const double x = random.Uniform(-31.0, 31.0), y = random.Uniform(-31.0, 31.0);
    const double radius_m = random.Chance(0.5) ? 0.0 : random.Uniform(0.05, 0.4);
    const double below_m = random.Uniform(0.001, 0.5);
    const Eigen::Vector3d center(x, y, ground.HeightAt({x, y}) - below_m);
    EXPECT_GT(DepthBelowGround(ground, center, radius_m), 0.5 * below_m);
  }
}

}  // namespace
}  // namespace latticeworld
