#include "latticeworld/scene/asset.h"

#include <gtest/gtest.h>

#include <cmath>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

Asset Tree(float trunk_radius_m) {
  Asset tree;
  tree.kind = AssetKind::kTree;
  tree.half_length_m = tree.half_width_m = 3.0f;
  tree.trunk_radius_m = trunk_radius_m;
  return tree;
}

TEST(AssetTest, OnlyTheTrunkOfATreeIsSolid) {
  const Asset tree = Tree(0.25f);
  EXPECT_DOUBLE_EQ(SolidRadius(tree), 0.25);
  EXPECT_TRUE(SolidContains(tree, {0.2, 0.0}, 0.0));
  EXPECT_FALSE(SolidContains(tree, {0.3, 0.0}, 0.0));
  EXPECT_TRUE(SolidContains(tree, {0.7, 0.0}, 0.5));
  EXPECT_FALSE(SolidContains(tree, {0.8, 0.0}, 0.5));
}

TEST(AssetTest, GroundCoverIsNeverSolid) {
  for (const AssetKind kind : {AssetKind::kBush, AssetKind::kDeadBranch, AssetKind::kGrassTuft,
                               AssetKind::kFlower, AssetKind::kCrop}) {
    Asset asset = Tree(0.0f);
    asset.kind = kind;
    EXPECT_FALSE(IsSolid(kind));
    EXPECT_EQ(SolidRadius(asset), 0.0);
    EXPECT_FALSE(SolidContains(asset, {0.0, 0.0}, 1.0)) << NameOf(kind);
  }
}

TEST(AssetTest, ABuildingIsARotatedRectangleWithRoundMargin) {
  Asset building;
  building.kind = AssetKind::kBuilding;
  building.x_m = 10.0f;
  building.yaw_rad = static_cast<float>(M_PI / 2.0);  // length runs north
  building.half_length_m = 4.0f;
  building.half_width_m = 3.0f;
  EXPECT_NEAR(SolidRadius(building), 5.0, 1e-6);
  EXPECT_TRUE(SolidContains(building, {10.0, 3.9}, 0.0));
  EXPECT_FALSE(SolidContains(building, {10.0, 4.1}, 0.0));
  EXPECT_TRUE(SolidContains(building, {12.9, 0.0}, 0.0));
  EXPECT_FALSE(SolidContains(building, {13.1, 0.0}, 0.0));
  // One metre off the corner (13, 4) both ways is 1.41 m away.
  EXPECT_FALSE(SolidContains(building, {14.0, 5.0}, 1.40));
  EXPECT_TRUE(SolidContains(building, {14.0, 5.0}, 1.43));
}

TEST(AssetTest, TheSolidCircleCoversTheSolidPart) {
  RandomStream random(7, "asset_test");
  Asset building;
  building.kind = AssetKind::kBuilding;
  building.half_length_m = 6.0f;
  building.half_width_m = 2.0f;
  for (int i = 0; i < 2000; ++i) {
    building.yaw_rad = static_cast<float>(random.Uniform(-M_PI, M_PI));
    const WorldPoint point = {random.Uniform(-9.0, 9.0), random.Uniform(-9.0, 9.0)};
    if (!SolidContains(building, point, 0.0)) continue;
    EXPECT_LE(std::hypot(point.x_m, point.y_m), SolidRadius(building));
  }
}

}  // namespace
}  // namespace latticeworld
