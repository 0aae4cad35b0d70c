// What grows on the ground, and the stones on it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latticeworld/scene/placement.h"
#include "latticeworld/scene/site.h"
#include "latticeworld/scene/vegetation/canopy.h"
#include "scene/test_world.h"

namespace latticeworld {
namespace {

// A lake in the west, with a gentle shore along x = -40.
std::shared_ptr<const Terrain> Lakeside(Vocabulary vocabulary, std::uint64_t seed) {
  TestGround ground;
  ground.vocabulary = vocabulary;
  ground.size_m = 128.0;
  ground.cells = 128;
  const double bend = static_cast<double>(seed);
  const auto shore_at = [bend](WorldPoint point) {
    return point.x_m + 40.0 + 8.0 * std::sin(0.05 * point.y_m + bend);
  };
  const char land = vocabulary == Vocabulary::kSuburb ? 'G' : 'B';
  ground.letter_at = [=](WorldPoint point) { return shore_at(point) < 0.0 ? 'W' : land; };
  ground.height_at_m = [=](WorldPoint point) {
    const double along = shore_at(point);
    return along < 0.0 ? std::max(-2.0, 0.1 * along) - 0.2 : 0.06 * std::min(along, 60.0);
  };
  ground.water_at_m = [=](WorldPoint point) { return shore_at(point) < 0.0 ? 0.0 : double{NAN}; };
  return MakeTerrain(ground);
}

TEST(GroundCoverTest, ReedAndWillowLineTheShore) {
  const auto catalogue = Catalogue::BuiltIn();
  for (const auto& vocabulary : EnumNames(Vocabulary{})) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const auto terrain = Lakeside(vocabulary.value, seed);
      const SceneAnswer answer = Build(terrain, MakeEnvironment(1.0), seed);
      const SiteMap sites(*terrain, 0);
      int reed = 0, willow = 0;
      for (const Asset& asset : answer.scene->assets) {
        const std::string& name = catalogue->models()[asset.model].name;
        if (name != "reed" && name != "willow shrub") continue;
        (name == "reed" ? reed : willow) += 1;
        const double most_m = name == "reed" ? 5.0 : 8.0;
        EXPECT_LE(sites.ToWater(asset.position()), most_m) << name;
        EXPECT_EQ(terrain->WaterDepthAt(asset.position()), 0.0);
      }
      EXPECT_GT(reed, 40) << "seed " << seed;
      EXPECT_GT(willow + reed, 50) << "seed " << seed;
    }
  }
}

TEST(GroundCoverTest, AShoreBreaksOffInPlaces) {
  const auto terrain = Lakeside(Vocabulary::kWild, 3);
  const SceneAnswer answer = Build(terrain, MakeEnvironment(1.0), 3);
  const auto catalogue = Catalogue::BuiltIn();
  std::vector<int> along(32, 0);  // pieces of four metres
  for (const Asset& asset : answer.scene->assets) {
    if (catalogue->models()[asset.model].name != "reed") continue;
    ++along[std::clamp(static_cast<int>((asset.y_m + 64.0f) / 4.0f), 0, 31)];
  }
  const auto bare = std::count_if(along.begin(), along.end(), [](int n) { return n <= 1; });
  EXPECT_GE(bare, 2);
  EXPECT_LE(bare, 24);
}

TEST(GroundCoverTest, FlowersOfOneKindStandInPatches) {
  for (int seed = 0; seed < 3; ++seed) {
    const SceneAnswer answer =
        Build(MakeUniform(Vocabulary::kWild, 'B'), MakeEnvironment(1.0), seed);
    const std::vector<Asset> flowers = OfKind(*answer.scene, AssetKind::kFlower);
    ASSERT_GT(flowers.size(), 1000u);
    // Per square of eight metres: far more uneven than chance, which has a ratio of one.
    std::vector<double> count(32 * 32, 0.0);
    for (const Asset& flower : flowers) {
      const int x = std::clamp(static_cast<int>((flower.x_m + 128.0f) / 8.0f), 0, 31);
      const int y = std::clamp(static_cast<int>((flower.y_m + 128.0f) / 8.0f), 0, 31);
      count[y * 32 + x] += 1.0;
    }
    const double mean = static_cast<double>(flowers.size()) / count.size();
    double variance = 0.0;
    for (const double n : count) variance += (n - mean) * (n - mean) / count.size();
    EXPECT_GT(variance / mean, 1.3);
  }
}

TEST(GroundCoverTest, BushesCrowdAlongTheEdgeOfTheForest) {
  TestGround ground;
  ground.vocabulary = Vocabulary::kWild;
  ground.letter_at = [](WorldPoint point) { return point.x_m < 0.0 ? 'F' : 'R'; };
  const auto terrain = MakeTerrain(ground);
  double edge = 0.0, inside = 0.0;
  for (int seed = 0; seed < 6; ++seed) {
    for (const Asset& bush :
         OfKind(*Build(terrain, MakeEnvironment(1.0), seed).scene, AssetKind::kBush)) {
      if (bush.x_m > -10.0f && bush.x_m < 0.0f) edge += 1.0 / 10.0;
      if (bush.x_m > -100.0f && bush.x_m < -40.0f) inside += 1.0 / 60.0;
    }
  }
  EXPECT_GT(edge, 1.2 * inside);
}

TEST(CanopyTest, CrownsHideTheSkyAboveThem) {
  std::vector<Asset> trees;
  for (int i = 0; i < 400; ++i) {
    Asset tree;
    tree.x_m = static_cast<float>(-99.0 + 5.0 * (i % 20));
    tree.y_m = static_cast<float>(-50.0 + 5.0 * (i / 20));
    tree.half_length_m = 3.0f;
    trees.push_back(tree);
  }
  const Canopy canopy(200.0, trees, 0);
  EXPECT_NEAR(canopy.At({-50.0, 0.0}), 1.0 - std::exp(-M_PI * 9.0 / 25.0), 0.05);
  EXPECT_NEAR(canopy.At({60.0, 0.0}), 0.0, 1e-3);
  EXPECT_EQ(Canopy(200.0).At({0.0, 0.0}), 0.0);
}

// A cliff runs through rocky land, the same above and below it.
TEST(StonesTest, StonesAreDenserBelowCliffs) {
  TestGround ground;
  ground.vocabulary = Vocabulary::kWild;
  ground.letter_at = [](WorldPoint) { return 'R'; };
  ground.height_at_m = [](WorldPoint point) {
    const double steep = std::tan(60.0 * M_PI / 180.0);
    if (point.x_m < 0.0) return 12.0 * steep - 0.02 * point.x_m;
    return point.x_m < 12.0 ? steep * (12.0 - point.x_m) : -0.05 * (point.x_m - 12.0);
  };
  const auto terrain = MakeTerrain(ground);
  double below = 0.0, above = 0.0, far = 0.0;
  for (int seed = 0; seed < 4; ++seed) {
    for (const Asset& stone :
         OfKind(*Build(terrain, MakeEnvironment(1.0), seed).scene, AssetKind::kStone)) {
      if (stone.x_m > 13.0f && stone.x_m < 38.0f) below += 1.0 / 25.0;
      if (stone.x_m > -100.0f && stone.x_m < -2.0f) above += 1.0 / 98.0;
      if (stone.x_m > 80.0f && stone.x_m < 120.0f) far += 1.0 / 40.0;
    }
  }
  EXPECT_GT(below, 3.0 * above);
  EXPECT_GT(below, 3.0 * far);
  EXPECT_GT(far, 0.0);
}

TEST(StonesTest, ManyAreSmallAndFewAreLarge) {
  const std::vector<Asset> stones =
      OfKind(*Build(MakeUniform(Vocabulary::kWild, 'R', 512.0), MakeEnvironment(1.0), 1).scene,
             AssetKind::kStone);
  ASSERT_GT(stones.size(), 1000u);
  std::vector<float> heights;
  for (const Asset& stone : stones) heights.push_back(stone.height_m);
  std::sort(heights.begin(), heights.end());
  double mean = 0.0;
  for (const float height : heights) mean += height / static_cast<double>(heights.size());
  EXPECT_GT(mean, 1.1 * heights[heights.size() / 2]);
}

}  // namespace
}  // namespace latticeworld
