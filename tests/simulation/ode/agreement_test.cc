// One ground for everybody: at random points the OctoMap, the elevation layer, the occupancy map,
// the height query, the rays' mesh and the collider of the simulation agree.

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/mapping/octree/octree.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/sensing/solids/ray_scene.h"
#include "latticeworld/simulation/ode/contacts/ground_contact.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

constexpr int kSeeds = 8;
constexpr int kPointsPerSeed = 400;
constexpr double kMeshTolerance_m = 0.01;  // rays and collider

// Hills with bumps and a lake, 40 to 90 m wide in cells of 0.3 to 0.8 m, with some of all assets.
Scene SomeScene(std::uint64_t seed) {
  RandomStream random(seed, "agreement");
  const double cell_m = random.Uniform(0.3, 0.8), relief_m = random.Uniform(0.5, 6.0);
  const double phase = random.Uniform(0.0, 6.0);
  const Scene land =
      MakeScene(random.UniformInt(130, 150), 140.0 * cell_m, [&](double x_m, double y_m) {
        return relief_m * std::sin(x_m / 9.0 + phase) * std::cos(y_m / 11.0) +
               random.Uniform(0.0, 0.1);
      });
  const auto place = [&] {
    return static_cast<float>(random.Uniform(-0.48, 0.48) * land.geometry().size_m());
  };
  std::vector<Asset> assets;
  for (int i = 0; i < 60; ++i) {
    assets.push_back(MakeTree(place(), place(), 7.0f, 1.5f, 0.25f));
    assets.push_back(MakeRound(AssetKind::kStone, place(), place(), 1.0f, 0.7f));
  }
  assets.push_back(MakeBuilding(place(), place(), 5.0f, 4.0f, 3.0f, 0.7f));
  return WithWater(WithAssets(land, assets), static_cast<float>(-0.3 * relief_m));
}

class AgreementTest : public testing::TestWithParam<int> {
 protected:
  AgreementTest()
      : seed_(static_cast<std::uint64_t>(GetParam())),
        scene_(SomeScene(seed_)),
        ground_(scene_.terrain->ground),
        random_(seed_, "points") {}

  WorldPoint AnyPoint() {
    const double half_m = scene_.geometry().half_size_m();
    return {random_.Uniform(-half_m, half_m), random_.Uniform(-half_m, half_m)};
  }

  const std::uint64_t seed_;
  const Scene scene_;
  const HeightField& ground_;
  RandomStream random_;
};

TEST_P(AgreementTest, TheRaysMeshIsTheGround) {
  const RayScene rays = RayScene::Create(ground_).value();
  for (int i = 0; i < kPointsPerSeed; ++i) {
    const WorldPoint p = AnyPoint();
    const double from_m = ground_.max_m() + 10.0;
    EXPECT_NEAR(from_m - rays.Distance({p.x_m, p.y_m, from_m}, {0.0, 0.0, -1.0}),
                ground_.HeightAt(p), kMeshTolerance_m);
  }
}

TEST_P(AgreementTest, TheColliderIsTheGround) {
  for (int i = 0; i < kPointsPerSeed; ++i) {
    const WorldPoint p = AnyPoint();
    const double height_m = ground_.HeightAt(p);
    EXPECT_EQ(TouchGround(ground_, {p.x_m, p.y_m, height_m + kMeshTolerance_m}, 0.0).count, 0);
    EXPECT_GT(TouchGround(ground_, {p.x_m, p.y_m, height_m - kMeshTolerance_m}, 0.0).count, 0);
  }
}

TEST_P(AgreementTest, TheElevationLayerIsTheGroundAtItsCells) {
  for (int i = 0; i < kPointsPerSeed; ++i) {
    const WorldPoint p = AnyPoint();
    const CellIndex cell = scene_.geometry().CellAt(p);
    const WorldPoint center = scene_.geometry().CenterOf(cell);
    const double half_cell_m = 0.5 * scene_.geometry().resolution_m() + 1e-9;
    ASSERT_LE(std::abs(p.x_m - center.x_m), half_cell_m);
    ASSERT_LE(std::abs(p.y_m - center.y_m), half_cell_m);
    EXPECT_NEAR(ground_.height_m()[cell], ground_.HeightAt(center), 1e-4);
  }
}

TEST_P(AgreementTest, TheOctomapsSurfaceIsTheGroundWithinHalfAVoxel) {
  Scene bare = scene_;
  bare.assets.clear();
  for (const double voxel_m : {scene_.geometry().resolution_m(), 0.25}) {
    const auto tree = BuildOctree(bare, {voxel_m, 1.0}, Progress()).value();
    const auto planted = BuildOctree(scene_, {voxel_m, 1.0}, Progress()).value();
    for (int i = 0; i < kPointsPerSeed; ++i) {
      const WorldPoint p = AnyPoint();
      const octomap::OcTreeKey key = tree->coordToKey(p.x_m, p.y_m, 0.0);
      const WorldPoint center = {tree->keyToCoord(key[0]), tree->keyToCoord(key[1])};
      const double height_m = ground_.HeightAt(center);
      // The highest voxel of the column.
      double top_m = -1e9;
      for (double z_m = height_m + 10.0; z_m > height_m - 10.0 && top_m == -1e9; z_m -= voxel_m) {
        if (tree->search(center.x_m, center.y_m, z_m) != nullptr)
          top_m = tree->keyToCoord(tree->coordToKey(z_m));
      }
      EXPECT_LE(std::abs(top_m - height_m), 0.5 * voxel_m + 1e-4) << p.x_m << " " << p.y_m;
      EXPECT_NE(planted->search(center.x_m, center.y_m, height_m), nullptr);
    }
  }
}

TEST_P(AgreementTest, TheOccupancyMapIsClosedWhereWaterIsDeepAndWhereSolidThingsStand) {
  const RobotLimits limits;
  const auto occupancy = BuildOccupancy(scene_, limits);
  const auto tree = BuildOctree(scene_, {0.1, 0.2}, Progress()).value();
  int closed = 0, solid = 0, open = 0;
  for (int i = 0; i < kPointsPerSeed; ++i) {
    // Every other point beside an asset.
    WorldPoint p = AnyPoint();
    if (i % 2 == 1) {
      const Asset& asset =
          scene_.assets[random_.UniformInt(0, static_cast<int>(scene_.assets.size()) - 1)];
      p = {asset.x_m + random_.Uniform(-1.5, 1.5), asset.y_m + random_.Uniform(-1.5, 1.5)};
    }
    const CellIndex cell = scene_.geometry().CellAt(p);
    const WorldPoint center = scene_.geometry().CenterOf(cell);
    const double height_m = ground_.HeightAt(center);
    const bool is_closed = occupancy[cell] == 100;
    closed += is_closed;
    // What the OctoMap has at knee height is in the robot's way.
    if (tree->search(center.x_m, center.y_m, height_m + 0.4) != nullptr &&
        ground_.SlopeAt(center) < 0.5) {
      ++solid;
      EXPECT_TRUE(is_closed) << center.x_m << " " << center.y_m;
    }
    if (scene_.terrain->WaterDepthAt(center) > limits.max_fording_depth_m + 1e-3) {
      EXPECT_TRUE(is_closed);
    }
    if (!is_closed) {
      ++open;
      for (const Asset& asset : scene_.assets)
        EXPECT_FALSE(SolidContains(asset, center, limits.radius_m));
      EXPECT_LE(scene_.terrain->WaterDepthAt(center), limits.max_fording_depth_m + 1e-3);
    }
  }
  EXPECT_GT(closed, 20);
  EXPECT_GT(solid, 5);
  EXPECT_GT(open, 20);
}

INSTANTIATE_TEST_SUITE_P(Seeds, AgreementTest, testing::Range(0, kSeeds));

}  // namespace
}  // namespace latticeworld
