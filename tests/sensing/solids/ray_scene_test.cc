#include "latticeworld/sensing/solids/ray_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "latticeworld/common/random.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

const Eigen::Vector3d kDown(0.0, 0.0, -1.0);

// Heights without any order, so that the other diagonal would be seen at once.
HeightField Rough(std::uint64_t seed, int cells, double size_m) {
  RandomStream random(seed, "rough");
  return MakeScene(cells, size_m, [&](double, double) { return random.Uniform(-1.0, 1.0); })
      .terrain->ground;
}

TEST(RaySceneTest, IsTheTriangulationOfTheHeightFieldOutToTheWorldsEdge) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const double size_m = 16.0 + 7.0 * static_cast<double>(seed);
    const HeightField ground = Rough(seed, 32, size_m);
    const Result<RayScene> rays = RayScene::Create(ground);
    ASSERT_TRUE(rays.ok()) << rays.status().ToString();
    RandomStream random(seed, "points");
    for (int i = 0; i < 1000; ++i) {
      const WorldPoint p = {random.Uniform(-0.5, 0.5) * size_m, random.Uniform(-0.5, 0.5) * size_m};
      EXPECT_NEAR(5.0 - rays->Distance({p.x_m, p.y_m, 5.0}, kDown), ground.HeightAt(p), 1e-4)
          << p.x_m << " " << p.y_m;
    }
  }
}

TEST(RaySceneTest, SlantingRaysEndOnTheGround) {
  const HeightField ground = Rough(1, 64, 64.0);
  const RayScene rays = RayScene::Create(ground).value();
  RandomStream random(2, "rays");
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d origin(random.Uniform(-20.0, 20.0), random.Uniform(-20.0, 20.0), 3.0);
    const Eigen::Vector3d direction =
        Eigen::Vector3d(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0), -1.0).normalized();
    const Eigen::Vector3d hit = origin + rays.Distance(origin, direction) * direction;
    EXPECT_NEAR(hit.z(), ground.HeightAt({hit.x(), hit.y()}), 1e-3);
    // Nothing was passed through on the way.
    for (double share = 0.05; share < 1.0; share += 0.05) {
      const Eigen::Vector3d point = origin + share * (hit - origin);
      EXPECT_GT(point.z(), ground.HeightAt({point.x(), point.y()}) - 1e-3);
    }
  }
}

TEST(RaySceneTest, RaysIntoTheSkyAndBesideTheWorldMeetNothing) {
  const RayScene rays = RayScene::Create(Rough(3, 32, 32.0)).value();
  EXPECT_TRUE(std::isinf(rays.Distance({0.0, 0.0, 5.0}, {0.0, 0.0, 1.0})));
  EXPECT_TRUE(std::isinf(rays.Distance({16.5, 0.0, 5.0}, kDown)));
  EXPECT_TRUE(std::isinf(rays.Distance({0.0, 0.0, 5.0}, {1.0, 0.0, 0.0})));
}

}  // namespace
}  // namespace latticeworld
