#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/meshes/mesh.h"
#include "latticeworld/scene/scene_changes.h"
#include "latticeworld/sensing/solids/agent_body.h"
#include "latticeworld/sensing/solids/ray_scene.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

using Eigen::Vector3f;

Scene Plain() {
  return MakeScene(64, 64.0, [](double, double) { return 1.0; });
}

RayScene RaysOf(const Scene& scene, const RaySceneOptions& options = {}) {
  return RayScene::Create(scene, options, Progress()).value();
}

Ray MakeRay(const Vector3f& origin_m, const Vector3f& direction) {
  Ray ray;
  ray.origin_m = origin_m;
  ray.direction = direction.normalized();
  return ray;
}

// The first hit on that part of any asset, past all others.
RayHit FirstOn(const RayScene& rays, Ray ray, MeshPart part) {
  for (int i = 0; i < 200; ++i) {
    const RayHit hit = rays.Trace(ray, kSeesSolid);
    if (hit.target == RayTarget::kNothing) return hit;
    if (hit.target == RayTarget::kAsset && hit.part == static_cast<std::uint8_t>(part)) return hit;
    ray.from_m = hit.distance_m + 1e-3f;
  }
  return {};
}

TEST(RayAssetsTest, RaysMeetAFallenTreeWhereItLiesAndNotWhereItStood) {
  // As slender as the model's mesh, so that its trunk is as thick as the tree's.
  const auto catalogue = Catalogue::BuiltIn();
  const std::uint8_t model = catalogue->models_of(AssetKind::kTree).front();
  const auto crown_m = static_cast<float>(0.3 * catalogue->models()[model].crown_per_trunk);
  const Scene scene = WithAssets(Plain(), {MakeTree(-9.0f, 0.0f, 12.0f, crown_m, 0.3f),
                                           MakeTree(0.0f, 0.0f, 12.0f, crown_m, 0.3f),
                                           MakeTree(9.0f, 0.0f, 12.0f, crown_m, 0.3f)});
  SceneChanges changes;
  // To the north, its stem's axis 0.4 m above the ground and rising a little.
  const Eigen::Vector3d foot(-9.0, 1.0, 1.4);
  const Eigen::Vector3d way = Eigen::Vector3d(0.0, 1.0, 0.1).normalized();
  changes.fallen = {{0, foot, foot + 12.0 * way}};
  changes.gone = {2};
  ASSERT_TRUE(Validate(changes, scene).ok());
  RaySceneOptions options;
  options.changes = &changes;
  const RayScene rays = RaysOf(scene, options);
  const auto across = [&](float x_m, float y_m, float z_m) {
    return FirstOn(rays, MakeRay({x_m - 4.0f, y_m, z_m}, {1.0f, 0.0f, 0.0f}), MeshPart::kBark);
  };
  // Only the middle one stands.
  EXPECT_EQ(across(-9.0f, 0.0f, 3.0f).index, 1u);
  EXPECT_EQ(across(0.0f, 0.0f, 3.0f).index, 1u);
  EXPECT_EQ(across(9.0f, 0.0f, 3.0f).target, RayTarget::kNothing);
  // The stem lies: met from above, about its radius above its axis, with a normal that looks up.
  for (const float along_m : {0.6f, 1.0f, 1.4f}) {
    const Ray down = MakeRay({-9.0f, 1.0f + along_m, 20.0f}, {0.0f, 0.0f, -1.0f});
    const RayHit hit = FirstOn(rays, down, MeshPart::kBark);
    ASSERT_EQ(hit.target, RayTarget::kAsset) << along_m;
    EXPECT_EQ(hit.index, 0u);
    const float axis_m = 1.4f + 0.1f * along_m;
    EXPECT_NEAR(20.0f - hit.distance_m, axis_m + 0.3f, 0.12f) << along_m;
    EXPECT_GT(hit.normal.z(), 0.8f);
    EXPECT_TRUE(rays.IsBlocked(down, kSeesSolid));
  }
}

TEST(RayAssetsTest, RaysMeetTrunksWhereBodiesMeetTheirCollisionCylinders) {
  const auto catalogue = Catalogue::BuiltIn();
  for (const std::uint8_t model : catalogue->models_of(AssetKind::kTree)) {
    for (int detail = 0; detail < kMeshDetails; ++detail) {
      constexpr float kTrunk_m = 0.3f;
      const double crown_per_trunk = catalogue->models()[model].crown_per_trunk;
      Asset tree =
          MakeTree(3.0f, -2.0f, 16.0f, static_cast<float>(crown_per_trunk) * kTrunk_m, kTrunk_m);
      tree.model = model;
      tree.yaw_rad = 0.7f;
      RaySceneOptions options;
      options.detail = detail;
      const RayScene rays = RaysOf(WithAssets(Plain(), {tree}), options);
      for (int turn = 0; turn < 16; ++turn) {
        const float heading = 0.1f + static_cast<float>(turn) * static_cast<float>(M_PI) / 8.0f;
        const Vector3f direction(std::cos(heading), std::sin(heading), 0.0f);
        const Vector3f breast(3.0f, -2.0f, 1.0f + 1.3f);
        const RayHit hit =
            FirstOn(rays, MakeRay(breast - 12.0f * direction, direction), MeshPart::kBark);
        ASSERT_EQ(hit.target, RayTarget::kAsset) << catalogue->models()[model].name;
        EXPECT_EQ(hit.index, 0u);
        // Coarse trunks have few sides.
        EXPECT_NEAR(hit.distance_m, 12.0f - kTrunk_m, (0.25f + 0.2f * detail) * kTrunk_m)
            << catalogue->models()[model].name << " detail " << detail;
      }
    }
  }
}

TEST(RayAssetsTest, BoxesOfHousesEndWhereTheirWallsDo) {
  Asset house = MakeBuilding(-4.0f, 6.0f, 7.0f, 5.0f, 4.0f, 0.6f);
  const RayScene rays = RaysOf(WithAssets(Plain(), {house}));
  const Vector3f front(std::cos(0.6f), std::sin(0.6f), 0.0f), side(-front.y(), front.x(), 0.0f);
  const Vector3f middle(-4.0f, 6.0f, 1.0f + 1.2f);
  for (const float sign : {-1.0f, 1.0f}) {
    EXPECT_NEAR(
        rays.Trace(MakeRay(middle + sign * 20.0f * front, -sign * front), kSeesSolid).distance_m,
        15.0f, 0.8f);
    EXPECT_NEAR(
        rays.Trace(MakeRay(middle + sign * 20.0f * side, -sign * side), kSeesSolid).distance_m,
        16.0f, 0.8f);
  }
}

TEST(RayAssetsTest, AHitSaysWhichAssetItIs) {
  RandomStream random(4, "assets");
  std::vector<Asset> assets;
  for (int row = 0; row < 6; ++row)
    for (int col = 0; col < 6; ++col)
      assets.push_back(MakeRound(AssetKind::kStone, -25.0f + 10.0f * static_cast<float>(col),
                                 -25.0f + 10.0f * static_cast<float>(row),
                                 static_cast<float>(random.Uniform(0.5, 3.0)),
                                 static_cast<float>(random.Uniform(0.5, 3.0))));
  const RayScene rays = RaysOf(WithAssets(Plain(), assets));
  for (std::size_t i = 0; i < assets.size(); ++i) {
    const RayHit hit =
        rays.Trace(MakeRay({assets[i].x_m, assets[i].y_m, 20.0f}, -Vector3f::UnitZ()), kSeesSolid);
    EXPECT_EQ(hit.target, RayTarget::kAsset);
    EXPECT_EQ(hit.index, i);
    EXPECT_EQ(static_cast<MeshPart>(hit.part), MeshPart::kStone);
    EXPECT_NEAR(hit.distance_m, 19.0f - assets[i].height_m, 0.3f * assets[i].height_m);
    EXPECT_GT(hit.normal.z(), 0.0f);
  }
}

TEST(RayAssetsTest, AnotherListMayStandInForTheScenesAssets) {
  const Scene scene = WithAssets(Plain(), {MakeRound(AssetKind::kStone, 0, 0, 3, 3)});
  const std::vector<Asset> none;
  RaySceneOptions options;
  options.assets = &none;
  const Ray down = MakeRay({0.0f, 0.0f, 20.0f}, -Vector3f::UnitZ());
  EXPECT_EQ(RaysOf(scene).Trace(down, kSeesSolid).target, RayTarget::kAsset);
  EXPECT_EQ(RaysOf(scene, options).Trace(down, kSeesSolid).target, RayTarget::kGround);
}

TEST(RayAssetsTest, AgentsAreMetOnlyWhenTheyAreThereAndAskedFor) {
  Scene scene = Plain();
  AgentStart sheep;
  sheep.category = AgentCategory::kSheep;
  sheep.position = {5.0, 5.0};
  scene.agents.push_back(sheep);
  const Ray ray = MakeRay({5.0f, 15.0f, 1.6f}, -Vector3f::UnitY());
  RaySceneOptions with;
  with.agents = true;
  EXPECT_EQ(RaysOf(scene).Trace(ray, kSeesAll).target, RayTarget::kNothing);
  EXPECT_EQ(RaysOf(scene, with).Trace(ray, kSeesSolid).target, RayTarget::kNothing);
  const RayHit hit = RaysOf(scene, with).Trace(ray, kSeesAll);
  EXPECT_EQ(hit.target, RayTarget::kAgent);
  EXPECT_EQ(hit.index, 0u);
  EXPECT_NEAR(hit.distance_m, 9.7f, 0.15f);
}

TEST(RayAssetsTest, WaterIsMetAtItsLevelOrSeenThrough) {
  const Scene lake =
      WithWater(MakeScene(64, 64.0, [](double x_m, double) { return 0.2 * x_m; }), 2.0f);
  const RayScene rays = RaysOf(lake);
  for (float x_m = -30.0f; x_m < 8.0f; x_m += 0.7f) {
    const Ray down = MakeRay({x_m, 3.0f, 12.0f}, -Vector3f::UnitZ());
    const RayHit water = rays.Trace(down, kSeesAll);
    EXPECT_EQ(water.target, RayTarget::kWater) << x_m;
    EXPECT_NEAR(water.distance_m, 10.0f, 1e-3f);
    const RayHit bed = rays.Trace(down, kSeesSolid);
    EXPECT_EQ(bed.target, RayTarget::kGround);
    EXPECT_NEAR(bed.distance_m, 12.0f - 0.2f * x_m, 1e-2f);
  }
  for (float x_m = 11.0f; x_m < 30.0f; x_m += 0.7f) {
    EXPECT_EQ(rays.Trace(MakeRay({x_m, 3.0f, 12.0f}, -Vector3f::UnitZ()), kSeesAll).target,
              RayTarget::kGround);
  }
}

TEST(RayAssetsTest, WhatBlocksARayIsWhatItMeets) {
  RandomStream random(5, "rays");
  std::vector<Asset> assets;
  for (int i = 0; i < 60; ++i) {
    assets.push_back(MakeTree(static_cast<float>(random.Uniform(-30.0, 30.0)),
                              static_cast<float>(random.Uniform(-30.0, 30.0)), 9.0f, 2.5f, 0.2f));
  }
  const RayScene rays = RaysOf(WithAssets(Plain(), assets));
  int blocked = 0;
  for (int i = 0; i < 3000; ++i) {
    Ray ray = MakeRay(
        {static_cast<float>(random.Uniform(-30.0, 30.0)),
         static_cast<float>(random.Uniform(-30.0, 30.0)),
         static_cast<float>(random.Uniform(1.1, 8.0))},
        {static_cast<float>(random.Normal(0.0, 1.0)), static_cast<float>(random.Normal(0.0, 1.0)),
         static_cast<float>(random.Normal(0.0, 0.3))});
    ray.to_m = 12.0f;
    const bool meets = rays.Trace(ray, kSeesAll).target != RayTarget::kNothing;
    EXPECT_EQ(rays.IsBlocked(ray, kSeesAll), meets);
    blocked += meets ? 1 : 0;
  }
  EXPECT_GT(blocked, 500);
  EXPECT_LT(blocked, 2900);
}

TEST(RayAssetsTest, FarAssetsHaveCoarserMeshes) {
  const Asset near = MakeTree(-20.0f, 0.0f, 9.0f, 2.5f, 0.2f);
  Asset far = MakeTree(20.0f, 0.0f, 9.0f, 2.5f, 0.2f);
  const auto& model = Catalogue::BuiltIn()->models()[near.model];
  EXPECT_GT(BuildMesh(model, 1.0, 0, 0).triangles.size(),
            2 * BuildMesh(model, 1.0, 2, 0).triangles.size());
  // What rays meet of the far one is what they meet when all are coarse.
  const Scene scene = WithAssets(Plain(), {near, far});
  RaySceneOptions by_distance, coarse, fine;
  by_distance.eye_m = Eigen::Vector3d(-20.0, 0.0, 2.0);
  by_distance.finest_within_m = 10.0;
  by_distance.medium_within_m = 20.0;
  coarse.detail = 2;
  fine.detail = 0;
  const RayScene mixed = RaysOf(scene, by_distance), all_coarse = RaysOf(scene, coarse),
                 all_fine = RaysOf(scene, fine);
  int like_coarse = 0, like_fine = 0;
  for (int i = 0; i < 400; ++i) {
    const auto at = [&](float x_m) {
      return MakeRay({x_m + 0.01f * static_cast<float>(i % 20 - 10) * 20.0f,
                      0.01f * static_cast<float>(i / 20 - 10) * 20.0f, 30.0f},
                     -Vector3f::UnitZ());
    };
    const auto same = [&](const RayScene& other, float x_m) {
      return mixed.Trace(at(x_m), kSeesSolid).distance_m ==
             other.Trace(at(x_m), kSeesSolid).distance_m;
    };
    like_coarse += same(all_coarse, 20.0f) ? 1 : 0;
    like_fine += same(all_fine, -20.0f) ? 1 : 0;
  }
  EXPECT_EQ(like_coarse, 400);
  EXPECT_EQ(like_fine, 400);
}

TEST(RayAssetsTest, EveryCategoryHasABodyThatStandsOnTheGround) {
  for (const auto& category : EnumNames(AgentCategory{})) {
    const BodyMesh body = BuildBody(category.value);
    ASSERT_EQ(body.triangles.size(), body.parts.size());
    ASSERT_FALSE(body.triangles.empty()) << category.name;
    float lowest_m = 1e9f;
    double volume_m3 = 0.0;
    for (const Vector3f& vertex : body.vertices) lowest_m = std::min(lowest_m, vertex.z());
    for (const auto& triangle : body.triangles)
      volume_m3 += body.vertices[triangle[0]]
                       .cross(body.vertices[triangle[1]])
                       .dot(body.vertices[triangle[2]]) /
                   6.0;
    EXPECT_NEAR(lowest_m, 0.0f, 0.15f) << category.name;
    EXPECT_GT(volume_m3, 0.001) << category.name;  // closed and turned outward
  }
}

TEST(RayAssetsTest, AnIllegalDetailIsRefusedAndACancelledSceneIsNotMade) {
  RaySceneOptions options;
  options.detail = 3;
  const auto refused = RayScene::Create(Plain(), options, Progress());
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().code(), StatusCode::kInvalidArgument);
  EXPECT_NE(refused.status().message().find("3"), std::string::npos);
  Progress cancelled;
  cancelled.Cancel();
  EXPECT_EQ(RayScene::Create(Plain(), {}, cancelled).status().code(), StatusCode::kCancelled);
}

}  // namespace
}  // namespace latticeworld
