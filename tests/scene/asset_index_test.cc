#include "latticeworld/scene/asset_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

std::vector<Asset> DrawAssets(double size_m, int count, RandomStream* random) {
  const float half_m = static_cast<float>(0.5 * size_m);
  std::vector<Asset> assets;
  for (int i = 0; i < count; ++i) {
    Asset asset;
    asset.kind = static_cast<AssetKind>(random->UniformInt(0, 7));
    asset.x_m = static_cast<float>(random->Uniform(-half_m, half_m));
    asset.y_m = static_cast<float>(random->Uniform(-half_m, half_m));
    // Some exactly on the edges and corners.
    if (i % 7 == 0) asset.x_m = i % 2 == 0 ? half_m : -half_m;
    if (i % 5 == 0) asset.y_m = i % 2 == 0 ? half_m : -half_m;
    asset.trunk_radius_m = static_cast<float>(random->Uniform(0.05, 0.6));
    asset.half_length_m = static_cast<float>(random->Uniform(0.1, 9.0));
    asset.half_width_m = static_cast<float>(random->Uniform(0.1, 9.0));
    assets.push_back(asset);
  }
  return assets;
}

TEST(AssetIndexTest, FindsWhatBruteForceFinds) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RandomStream random(seed, "asset_index_test");
    const double size_m = random.Uniform(16.0, 300.0);
    const std::vector<Asset> assets = DrawAssets(size_m, 200, &random);
    const AssetIndex index(size_m, assets);
    for (int query = 0; query < 100; ++query) {
      // Beyond the world, too.
      const WorldPoint point = {random.Uniform(-0.7, 0.7) * size_m,
                                random.Uniform(-0.7, 0.7) * size_m};
      const double radius_m = query % 3 == 0 ? 0.0 : random.Uniform(0.0, 0.5 * size_m);
      std::vector<int> visits(assets.size(), 0);
      index.ForEachNear(point, radius_m, [&visits](std::uint32_t asset) { ++visits[asset]; });
      for (std::size_t i = 0; i < assets.size(); ++i) {
        const double gap_m = std::hypot(assets[i].x_m - point.x_m, assets[i].y_m - point.y_m) -
                             SolidRadius(assets[i]) - radius_m;
        const bool near = IsSolid(assets[i].kind) && gap_m <= 0.0;
        const bool far = !IsSolid(assets[i].kind) || gap_m > 1e-4;
        if (near) {
          ASSERT_EQ(visits[i], 1) << "seed " << seed << " asset " << i;
        }
        if (far) {
          ASSERT_EQ(visits[i], 0) << "seed " << seed << " asset " << i;
        }
      }
    }
  }
}

TEST(AssetIndexTest, AnEmptyIndexVisitsNothing) {
  int visits = 0;
  const auto count = [&visits](std::uint32_t) { ++visits; };
  AssetIndex().ForEachNear({0.0, 0.0}, 100.0, count);
  AssetIndex(64.0, {}).ForEachNear({0.0, 0.0}, 100.0, count);
  EXPECT_EQ(visits, 0);
}

TEST(AssetIndexTest, VisitsInTheSameOrderEveryTime) {
  RandomStream random(3, "asset_index_test/order");
  const std::vector<Asset> assets = DrawAssets(100.0, 300, &random);
  std::vector<std::uint32_t> first, second;
  AssetIndex(100.0, assets).ForEachNear({0.0, 0.0}, 80.0, [&](auto i) { first.push_back(i); });
  AssetIndex(100.0, assets).ForEachNear({0.0, 0.0}, 80.0, [&](auto i) { second.push_back(i); });
  EXPECT_FALSE(first.empty());
  EXPECT_EQ(first, second);
}

}  // namespace
}  // namespace latticeworld
