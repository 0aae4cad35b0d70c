#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/solid_set.h"
#include "scene/test_world.h"

namespace latticeworld {
namespace {

TEST(PlacementTest, AnyNumberOfThreadsGivesTheSameBytes) {
  for (const auto& vocabulary : EnumNames(Vocabulary{})) {
    SceneRequest request =
        MakeRequest(MakePatchwork(vocabulary.value, 3), MakeEnvironment(0.8), 21);
    request.threads = 1;
    const Progress progress;
    const SceneAnswer one = BuildScene(request, progress).value();
    ASSERT_GT(one.scene->assets.size(), 1000u);
    for (const int threads : {2, 3, 7}) {
      request.threads = threads;
      const SceneAnswer many = BuildScene(request, progress).value();
      EXPECT_TRUE(SameBytes(one.scene->assets, many.scene->assets)) << threads << " threads";
      EXPECT_EQ(one.warnings, many.warnings);
    }
  }
}

TEST(PlacementTest, ArtisticStyleMovesNothing) {
  for (const auto& vocabulary : EnumNames(Vocabulary{})) {
    const auto terrain = MakePatchwork(vocabulary.value, 5);
    EnvironmentConfig environment = MakeEnvironment(0.8);
    const SceneAnswer realistic = Build(terrain, environment, 7);
    for (const auto& style : EnumNames(ArtisticStyle{})) {
      environment.coarse.artistic_style = style.value;
      EXPECT_TRUE(SameBytes(realistic.scene->assets, Build(terrain, environment, 7).scene->assets))
          << style.name;
    }
  }
}

// With the index, and nothing that was only reserved.
TEST(PlacementTest, AnAssetTakesLessThan64Bytes) {
  const SceneAnswer answer =
      Build(MakeUniform(Vocabulary::kWild, 'F', 512.0), MakeEnvironment(1.0), 1);
  const Scene& scene = *answer.scene;
  ASSERT_GT(CountOf(scene, AssetKind::kTree), 20000);
  const std::size_t bytes = scene.assets.capacity() * sizeof(Asset) + scene.index.bytes();
  EXPECT_LT(bytes, 64 * scene.assets.size());
}

TEST(SolidSetTest, FindsOverlapsOfSmallAndLargeCircles) {
  SolidSet solids(200.0);
  solids.Add({10.0, 10.0}, 0.3);
  solids.Add({-40.0, 20.0}, 12.0);
  EXPECT_TRUE(solids.Overlaps({10.5, 10.0}, 0.3));
  EXPECT_FALSE(solids.Overlaps({10.7, 10.0}, 0.3));
  EXPECT_TRUE(solids.Overlaps({-27.9, 20.0}, 0.3));
  EXPECT_FALSE(solids.Overlaps({-27.6, 20.0}, 0.3));
  EXPECT_TRUE(solids.Overlaps({0.0, 20.0}, 30.0));
  EXPECT_FALSE(solids.OverlapsLarge({10.0, 10.0}, 0.3));
  EXPECT_TRUE(solids.OverlapsLarge({-40.0, 20.0}, 0.3));
  // Against every pair, at random.
  RandomStream random(3, "solid_set_test");
  struct Circle {
    WorldPoint point;
    double radius_m;
  };
  std::vector<Circle> circles;
  SolidSet many(200.0);
  for (int i = 0; i < 500; ++i) {
    const Circle circle = {
        {random.Uniform(-100.0, 100.0), random.Uniform(-100.0, 100.0)},
        random.Chance(0.8) ? random.Uniform(0.1, 1.0) : random.Uniform(1.0, 9.0)};
    const bool overlaps = std::any_of(circles.begin(), circles.end(), [&](const Circle& other) {
      return std::hypot(other.point.x_m - circle.point.x_m, other.point.y_m - circle.point.y_m) <
             other.radius_m + circle.radius_m;
    });
    EXPECT_EQ(many.Overlaps(circle.point, circle.radius_m), overlaps);
    many.Add(circle.point, circle.radius_m);
    circles.push_back(circle);
  }
}

}  // namespace
}  // namespace latticeworld
