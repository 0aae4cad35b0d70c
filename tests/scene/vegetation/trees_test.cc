#include "latticeworld/scene/vegetation/trees.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "latticeworld/scene/vegetation/blue_noise.h"
#include "scene/test_world.h"
#include "scene/vegetation/even_points.h"

namespace latticeworld {
namespace {

double MeanSlenderness(const std::vector<Asset>& trees) {
  double sum = 0.0;
  for (const Asset& tree : trees) sum += tree.height_m / (2.0 * tree.trunk_radius_m);
  return sum / static_cast<double>(trees.size());
}

// Variance over mean of the numbers in squares: 1 for a random set, below for an even one.
double ClumpingIndex(const std::vector<Asset>& assets, double size_m, double square_m) {
  const int side = static_cast<int>(size_m / square_m);
  std::vector<double> count(static_cast<std::size_t>(side) * side, 0.0);
  for (const Asset& asset : assets) {
    const int x = std::clamp(static_cast<int>((asset.x_m + 0.5 * size_m) / square_m), 0, side - 1);
    const int y = std::clamp(static_cast<int>((asset.y_m + 0.5 * size_m) / square_m), 0, side - 1);
    count[y * side + x] += 1.0;
  }
  double mean = 0.0, square = 0.0;
  for (const double n : count) mean += n / static_cast<double>(count.size());
  for (const double n : count) square += (n - mean) * (n - mean);
  return square / static_cast<double>(count.size()) / mean;
}

TEST(TreesTest, StandsAreTheMoreSlenderTheDenserTheyAre) {
  EXPECT_EQ(StandOf(20.0, 0.0006).slenderness, 40.0);
  EXPECT_EQ(StandOf(20.0, 0.0006).height, 1.0);
  double slender = 40.0, height = 1.0;
  for (const double per_hectare : {200.0, 400.0, 800.0, 1600.0, 3200.0}) {
    const Stand stand = StandOf(20.0, per_hectare / 1e4);
    EXPECT_GE(stand.slenderness, slender);
    EXPECT_LE(stand.slenderness, 100.0);
    EXPECT_LE(stand.height, height);
    slender = stand.slenderness;
    height = stand.height;
  }
  // Reineke's line: 700 stems a hectare have ten inches.
  EXPECT_NEAR(20.0 / StandOf(20.0, 0.07).slenderness, 0.254, 1e-9);
  EXPECT_LT(StandOf(20.0, 0.32).height, 0.7);
}

TEST(TreesTest, SizesVaryWithinTheModelAndCrownsFitTheirTrunks) {
  const auto catalogue = Catalogue::BuiltIn();
  const SceneAnswer answer = Build(MakeUniform(Vocabulary::kWild, 'F'), MakeEnvironment(1.0), 2);
  const std::vector<Asset> trees = OfKind(*answer.scene, AssetKind::kTree);
  std::set<float> heights, crowns;
  for (const Asset& tree : trees) {
    const AssetModel& model = catalogue->models()[tree.model];
    ASSERT_EQ(model.kind, AssetKind::kTree);
    heights.insert(tree.height_m);
    crowns.insert(tree.half_length_m);
    EXPECT_LE(tree.height_m, model.height_m.high);
    EXPECT_GT(tree.height_m, 0.3 * model.height_m.low);
    EXPECT_EQ(tree.half_length_m,
              static_cast<float>(model.crown_per_trunk * double{tree.trunk_radius_m}));
    EXPECT_EQ(tree.half_length_m, tree.half_width_m);
    const double slenderness = tree.height_m / (2.0 * tree.trunk_radius_m);
    EXPECT_TRUE(slenderness > 40.0 / 1.16 && slenderness < 100.0 / 0.84) << slenderness;
    EXPECT_LT(tree.half_length_m, 0.36 * tree.height_m);
  }
  EXPECT_GT(heights.size(), 9 * trees.size() / 10);
  EXPECT_GT(crowns.size(), 9 * trees.size() / 10);
}

TEST(TreesTest, ForestsAreSlenderAndMeadowTreesStout) {
  const auto forest = MakeUniform(Vocabulary::kSuburb, 'F');
  const double dense =
      MeanSlenderness(OfKind(*Build(forest, MakeEnvironment(1.0), 1).scene, AssetKind::kTree));
  const double sparse =
      MeanSlenderness(OfKind(*Build(forest, MakeEnvironment(0.3), 1).scene, AssetKind::kTree));
  const double alone = MeanSlenderness(
      OfKind(*Build(MakeUniform(Vocabulary::kSuburb, 'G'), MakeEnvironment(1.0), 1).scene,
             AssetKind::kTree));
  EXPECT_TRUE(dense > 60.0 && dense < 100.0) << dense;
  EXPECT_GT(dense, sparse + 15.0);
  EXPECT_LT(alone, 45.0);
}

TEST(TreesTest, TreesAreStuntedNearTheirLimitOfAltitude) {
  AssetModel model =
      Catalogue::BuiltIn()->models()[Catalogue::BuiltIn()->models_of(AssetKind::kTree)[0]];
  double low = 0.0, high = 0.0;
  for (int i = 0; i < 200; ++i) {
    PointRandom random(1, i), same(1, i);
    Asset tree;
    SizeTree(model, 1.0, 0.01, &random, &tree);
    low += tree.height_m;
    SizeTree(model, 0.1, 0.01, &same, &tree);
    high += tree.height_m;
  }
  EXPECT_NEAR(high / low, 0.505, 1e-3);
}

TEST(TreesTest, OnlySmallTreesStandAmongHouses) {
  const auto catalogue = Catalogue::BuiltIn();
  const SceneAnswer answer = Build(MakeUniform(Vocabulary::kSuburb, 'B'), MakeEnvironment(1.0), 3);
  const std::vector<Asset> trees = OfKind(*answer.scene, AssetKind::kTree);
  EXPECT_GT(trees.size(), 30u);
  for (const Asset& tree : trees) EXPECT_LE(tree.height_m, 8.0f);
}

TEST(TreesTest, CrownsStayOutOfHouses) {
  for (int seed = 0; seed < 5; ++seed) {
    const SceneAnswer answer =
        Build(MakePatchwork(Vocabulary::kSuburb, seed), MakeEnvironment(1.0), seed);
    for (const Asset& tree : OfKind(*answer.scene, AssetKind::kTree)) {
      for (const Asset& house : OfKind(*answer.scene, AssetKind::kBuilding)) {
        // Trees of gardens stand where settlements want them.
        if (tree.height_m <= 8.0f) continue;
        EXPECT_FALSE(SolidContains(house, tree.position(), 0.3 * tree.half_length_m));
      }
    }
  }
}

// Against the same number of trees without clumping, which keep apart.
TEST(TreesTest, TreesClumpInForestsAndMoreOnOpenLand) {
  for (int seed = 0; seed < 3; ++seed) {
    const double forest = ClumpingIndex(
        OfKind(*Build(MakeUniform(Vocabulary::kWild, 'F'), MakeEnvironment(1.0), seed).scene,
               AssetKind::kTree),
        256.0, 16.0);
    RandomStream random(seed, "plain");
    std::vector<Asset> plain;
    for (const WorldPoint& point : EvenPoints(256.0, 0.08, random.NextBits())) {
      plain.push_back(Asset());
      plain.back().x_m = static_cast<float>(point.x_m);
      plain.back().y_m = static_cast<float>(point.y_m);
    }
    EXPECT_GT(forest, 2.0 * ClumpingIndex(plain, 256.0, 16.0));
    const double meadow = ClumpingIndex(
        OfKind(*Build(MakeUniform(Vocabulary::kWild, 'B', 512.0), MakeEnvironment(1.0), seed).scene,
               AssetKind::kTree),
        512.0, 32.0);
    EXPECT_GT(meadow, 1.3) << "in groups, not by chance";
  }
}

}  // namespace
}  // namespace latticeworld
