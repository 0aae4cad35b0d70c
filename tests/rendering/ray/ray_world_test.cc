#include "latticeworld/rendering/ray/ray_world.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

Ray Downward(double height_m, double angle_rad, double heading_rad) {
  Ray ray;
  ray.origin_m = {3.0f, -2.0f, static_cast<float>(height_m)};
  ray.direction = Eigen::Vector3d(std::cos(angle_rad) * std::cos(heading_rad),
                                  std::cos(angle_rad) * std::sin(heading_rad), -std::sin(angle_rad))
                      .cast<float>();
  return ray;
}

TEST(RayWorldTest, MirrorImagesOfASmallWorldGoOnToTheHorizon) {
  const Scene scene = WithAssets(MakeScene(32, 32.0, [](double, double) { return 5.0; }),
                                 {MakeTree(10.0f, 10.0f, 12.0f, 2.0f, 0.2f)});
  const auto rays = RayScene::Create(scene, {}, Progress());
  ASSERT_TRUE(rays.ok());
  const RayWorld world(scene, *rays, RaySurroundings::kMirrors, 1.0f);
  for (const double height_m : {6.7, 60.0, 505.0}) {
    for (const double away_m : {100.0, 2000.0, 11000.0}) {
      for (const double heading_rad : {0.0, 0.7, 2.0, 4.4}) {
        const double angle_rad = std::atan2(height_m - 5.0, away_m);
        const WorldHit hit = world.Trace(Downward(height_m, angle_rad, heading_rad), kSeesSolid);
        // A tree may stand before the ground, but air ends the view nowhere.
        EXPECT_NE(hit.hit.target, RayTarget::kNothing) << height_m << " " << away_m;
        if (hit.hit.target != RayTarget::kGround) continue;
        EXPECT_NEAR(hit.hit.distance_m * std::cos(angle_rad), away_m, 0.01 * away_m);
        EXPECT_LE(hit.point_m.head<2>().cwiseAbs().maxCoeff(), 16.01f);
      }
    }
  }
}

TEST(RayWorldTest, TheSkyIsAboveTheHorizon) {
  const Scene scene = MakeScene(32, 32.0, [](double, double) { return 5.0; });
  const auto rays = RayScene::Create(scene, {}, Progress());
  ASSERT_TRUE(rays.ok());
  const RayWorld world(scene, *rays, RaySurroundings::kMirrors, 1.0f);
  EXPECT_EQ(world.Trace(Downward(6.7, -0.01, 0.3), kSeesSolid).hit.target, RayTarget::kNothing);
}

}  // namespace
}  // namespace latticeworld
