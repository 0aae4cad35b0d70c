#include "latticeworld/sensing/sensor_scene.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/meshes/mesh.h"
#include "mapping/hand_made_scene.h"
#include "sensing/sensed_things.h"

namespace latticeworld {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

std::shared_ptr<const Scene> Plain(std::vector<Asset> assets = {}) {
  return std::make_shared<Scene>(
      WithAssets(MakeScene(64, 64.0, [](double, double) { return 1.0; }), std::move(assets)));
}

SensorScene SensorsOf(std::shared_ptr<const Scene> scene, const SensorSceneOptions& options = {}) {
  return SensorScene::Create(std::move(scene), options, Progress()).value();
}

RayHit TraceOne(const SensorScene& scene, const Ray& ray, RaySights sights = kSeesAll,
                std::uint32_t except_agent = SensorScene::kNoAgent) {
  RayHit hit;
  scene.Trace(&ray, 1, sights, except_agent, &hit);
  return hit;
}

TEST(SensorSceneTest, ACrateIsMetWhereItStandsAndWhereItIsMovedTo) {
  SensorScene sensors = SensorsOf(Plain());
  SensedWorld world;
  world.props = {MakeProp(PropKind::kCrate, {2.0, 1.0, 1.0}, {6.0, 0.0, 1.0})};
  ASSERT_TRUE(sensors.Update(world).ok());
  const Ray east = MakeRay({0.0f, 0.0f, 1.5f}, Vector3f::UnitX());
  const RayHit hit = TraceOne(sensors, east);
  EXPECT_EQ(hit.target, RayTarget::kProp);
  EXPECT_EQ(hit.index, 0u);
  EXPECT_NEAR(hit.distance_m, 5.0f, 1e-5f);
  EXPECT_NEAR((hit.normal + Vector3f::UnitX()).norm(), 0.0f, 1e-6f);
  EXPECT_EQ(TraceOne(sensors, east, kSeesAgents | kSeesWater).target, RayTarget::kNothing);
  // After a quarter turn its short side lies along the ray.
  world.props[0] = MakeProp(PropKind::kCrate, {2.0, 1.0, 1.0}, {9.0, 0.0, 1.0}, 0.5 * M_PI);
  ASSERT_TRUE(sensors.Update(world).ok());
  EXPECT_NEAR(TraceOne(sensors, east).distance_m, 8.5f, 1e-5f);
  world.props.clear();
  ASSERT_TRUE(sensors.Update(world).ok());
  EXPECT_EQ(TraceOne(sensors, east).target, RayTarget::kNothing);
}

TEST(SensorSceneTest, PropsAreAsLargeAsTheirBodies) {
  SensorScene sensors = SensorsOf(Plain());
  SensedWorld world;
  // The stone's middle is 0.795 of its radius above its origin, the gate's panel begins at its
  // hinge.
  world.props = {MakeProp(PropKind::kLooseStone, {2.0, 2.0, 2.0}, {0.0, 0.0, 1.0}),
                 MakeProp(PropKind::kGate, {3.0, 0.2, 1.5}, {0.0, 10.0, 1.0}),
                 MakeProp(PropKind::kBridge, {6.0, 2.0, 0.3}, {0.0, -10.0, 1.0}),
                 MakeProp(PropKind::kPost, {0.2, 0.2, 2.0}, {10.0, 0.0, 1.0})};
  ASSERT_TRUE(sensors.Update(world).ok());
  const auto down = [&](float x_m, float y_m) {
    return TraceOne(sensors, MakeRay({x_m, y_m, 21.0f}, -Vector3f::UnitZ()));
  };
  EXPECT_NEAR(20.0f - down(0.0f, 0.0f).distance_m, 1.794654f, 2e-3f);
  EXPECT_NEAR(20.0f - down(0.6f, 0.0f).distance_m, 0.794654f + 0.8f, 5e-3f);
  EXPECT_EQ(down(0.1f, 10.0f).index, 1u);
  EXPECT_EQ(down(2.9f, 10.0f).index, 1u);
  EXPECT_NEAR(20.0f - down(1.0f, 10.0f).distance_m, 1.56f, 1e-4f);
  EXPECT_EQ(down(-0.1f, 10.0f).target, RayTarget::kGround);
  EXPECT_NEAR(20.0f - down(-2.9f, -10.9f).distance_m, 0.3f, 1e-4f);
  EXPECT_NEAR(20.0f - down(10.05f, 0.05f).distance_m, 2.0f, 1e-4f);
  EXPECT_EQ(down(10.15f, 0.0f).target, RayTarget::kGround);
}

TEST(SensorSceneTest, AnAgentIsMetWhereItIsButNotByItsOwnRays) {
  SensorScene sensors = SensorsOf(Plain());
  SensedWorld world;
  for (const double x_m : {0.0, 5.0, 9.0}) world.agents.push_back(MakeRobot({x_m, 0.0, 1.0}));
  world.props = {MakeProp(PropKind::kCrate, {1.0, 1.0, 1.0}, {20.0, 0.0, 1.0})};
  ASSERT_TRUE(sensors.Update(world).ok());
  const Ray east = MakeRay({-3.0f, 0.0f, 1.3f}, Vector3f::UnitX());
  EXPECT_EQ(TraceOne(sensors, east).target, RayTarget::kAgent);
  EXPECT_EQ(TraceOne(sensors, east).index, 0u);
  EXPECT_NEAR(TraceOne(sensors, east).distance_m, 2.55f, 1e-4f);
  EXPECT_EQ(TraceOne(sensors, east, kSeesAll, 0).index, 1u);
  EXPECT_NEAR(TraceOne(sensors, east, kSeesAll, 0).distance_m, 7.55f, 1e-4f);
  // From within its hull.
  const Ray own = MakeRay({5.0f, 0.0f, 1.3f}, Vector3f::UnitX());
  EXPECT_NEAR(TraceOne(sensors, own, kSeesAll, 1).distance_m, 3.55f, 1e-4f);
  EXPECT_TRUE(sensors.IsBlocked(own, kSeesAgents, 1));
  EXPECT_FALSE(sensors.IsBlocked(MakeRay({8.5f, 0.0f, 1.3f}, Vector3f::UnitX()), kSeesAgents, 2));
  // What is no agent is not passed through, whatever its number in the scene.
  for (const std::uint32_t except : {2u, 3u, 4u, SensorScene::kNoAgent})
    EXPECT_EQ(TraceOne(sensors, east, kSeesSolid, except).target, RayTarget::kProp);
}

TEST(SensorSceneTest, BodiesHaveTheSizeOfTheirSpecies) {
  SensorScene sensors = SensorsOf(Plain());
  for (const auto& [category, name] : EnumNames(AgentCategory{})) {
    const auto top_m = [&, &category = category](double height_m, double radius_m) {
      SensedWorld world;
      world.agents = {MakeRobot({0.0, 0.0, 1.0})};
      world.agents[0].category = category;
      world.agents[0].height_m = height_m;
      world.agents[0].radius_m = radius_m;
      EXPECT_TRUE(sensors.Update(world).ok());
      double highest_m = 0.0;
      for (double x_m = -1.0; x_m <= 1.0; x_m += 0.02) {
        const RayHit hit = TraceOne(
            sensors,
            MakeRay(Vector3d(radius_m * x_m, 0.0, 31.0).cast<float>(), -Vector3f::UnitZ()));
        if (hit.target == RayTarget::kAgent) highest_m = std::max(highest_m, 30.0 - hit.distance_m);
      }
      return highest_m;
    };
    // Of the wheeled robot the mast is seen from above.
    const double over = category == AgentCategory::kWheeledRobot ? 0.78 / 0.43 : 1.0;
    EXPECT_NEAR(top_m(1.5, 0.8), over * 1.5, 0.25) << name;
    EXPECT_NEAR(top_m(3.0, 0.8), 2.0 * top_m(1.5, 0.8), 0.03) << name;
  }
}

TEST(SensorSceneTest, AFelledTreeIsMetWhereItLiesAndNoMoreWhereItStood) {
  const auto catalogue = Catalogue::BuiltIn();
  const std::uint8_t model = catalogue->models_of(AssetKind::kTree).front();
  const auto crown_m = static_cast<float>(0.3 * catalogue->models()[model].crown_per_trunk);
  for (const bool baked : {false, true}) {
    SensorSceneOptions options;
    if (!baked) options.max_baked_triangles = 0;
    SensorScene sensors = SensorsOf(Plain({MakeTree(0.0f, 0.0f, 12.0f, crown_m, 0.3f),
                                           MakeTree(1.0f, 12.0f, 12.0f, 1.0f, 0.1f)}),
                                    options);
    ASSERT_TRUE(sensors.Focus({Vector3d::Zero()}).ok());
    const Ray at_stem = MakeRay({-4.0f, 0.0f, 1.5f}, Vector3f::UnitX());
    // Past the standing crown, down on where the stem will lie.
    const Ray at_ground = MakeRay({0.0f, -10.0f, 20.0f}, -Vector3f::UnitZ());
    ASSERT_EQ(TraceOne(sensors, at_stem).target, RayTarget::kAsset);
    ASSERT_EQ(TraceOne(sensors, at_ground).target, RayTarget::kGround);
    SensedWorld world;
    world.felled = {{0, {0.0, 0.0, 1.4}, {0.0, -12.0, 1.4}}};
    ASSERT_TRUE(sensors.Update(world).ok());
    EXPECT_EQ(TraceOne(sensors, at_stem).target, RayTarget::kAsset);  // its foot
    EXPECT_FALSE(sensors.IsBlocked(MakeRay({-4.0f, 0.0f, 4.0f}, Vector3f::UnitX()), kSeesSolid,
                                   SensorScene::kNoAgent));
    // Somewhere along the stem: single rays pass between the twigs of its crown.
    RayHit lying;
    for (float y_m = -4.0f; y_m > -11.0f && lying.target != RayTarget::kAsset; y_m -= 0.25f)
      lying = TraceOne(sensors, MakeRay({0.0f, y_m, 20.0f}, -Vector3f::UnitZ()));
    EXPECT_EQ(lying.target, RayTarget::kAsset);
    EXPECT_EQ(lying.index, 0u);
    EXPECT_GT(lying.normal.z(), 0.0f);
    // Gone, and all as in the beginning again.
    world.felled.clear();
    world.gone = {0};
    ASSERT_TRUE(sensors.Update(world).ok());
    EXPECT_EQ(TraceOne(sensors, at_stem).target, RayTarget::kNothing);
    EXPECT_EQ(TraceOne(sensors, at_ground).target, RayTarget::kGround);
    ASSERT_TRUE(sensors.Update(SensedWorld()).ok());
    EXPECT_EQ(TraceOne(sensors, at_stem).index, 0u);
    EXPECT_EQ(TraceOne(sensors, at_stem).target, RayTarget::kAsset);
  }
}

TEST(SensorSceneTest, WaterIsMetByThoseWhoSeeIt) {
  const auto scene = std::make_shared<Scene>(
      WithWater(MakeScene(64, 64.0, [](double x_m, double) { return 0.1 * x_m; }), 0.0f));
  const SensorScene sensors = SensorsOf(scene);
  const Ray down = MakeRay({-10.0f, 0.0f, 5.0f}, -Vector3f::UnitZ());
  EXPECT_EQ(TraceOne(sensors, down).target, RayTarget::kWater);
  EXPECT_NEAR(TraceOne(sensors, down).distance_m, 5.0f, 1e-4f);
  EXPECT_NEAR(TraceOne(sensors, down).normal.z(), 1.0f, 1e-5f);
  EXPECT_EQ(TraceOne(sensors, down, kSeesSolid).target, RayTarget::kGround);
  EXPECT_NEAR(TraceOne(sensors, down, kSeesSolid).distance_m, 6.0f, 1e-3f);
  EXPECT_EQ(TraceOne(sensors, down, 0u).target, RayTarget::kNothing);
  Ray shallow = down;
  shallow.to_m = 5.5f;
  EXPECT_TRUE(sensors.IsBlocked(shallow, kSeesAll, SensorScene::kNoAgent));
  EXPECT_FALSE(sensors.IsBlocked(shallow, kSeesSolid, SensorScene::kNoAgent));
}

TEST(SensorSceneTest, WhatIsNowhereIsNotMet) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  SensorScene sensors = SensorsOf(Plain({MakeTree(0.0f, 9.0f, 12.0f, 3.0f, 0.3f)}));
  SensedWorld world;
  world.agents = {MakeRobot({kNan, 0.0, 1.0}), MakeRobot({5.0, 0.0, 1.0}),
                  MakeRobot({1e300, 0.0, 1.0})};
  world.props = {MakeProp(PropKind::kCrate, {0.0, 1.0, 1.0}, {3.0, 0.0, 1.0})};
  world.felled = {{0, Vector3d::Zero(), Vector3d::Zero()}};
  ASSERT_TRUE(sensors.Update(world).ok());
  ASSERT_TRUE(sensors.Focus({{kNan, 0.0, 0.0}, {1e300, -1e300, 0.0}, {0.0, 0.0, 0.0}}).ok());
  const RayHit hit = TraceOne(sensors, MakeRay({-3.0f, 0.0f, 1.3f}, Vector3f::UnitX()));
  EXPECT_EQ(hit.target, RayTarget::kAgent);
  EXPECT_EQ(hit.index, 1u);
}

TEST(SensorSceneTest, RaysThatAreNoneMeetNothingAndHarmNoOther) {
  const SensorScene sensors = SensorsOf(Plain({MakeTree(0.0f, 9.0f, 12.0f, 3.0f, 0.3f)}));
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const Ray down = MakeRay({1.0f, 0.0f, 5.0f}, -Vector3f::UnitZ());
  std::vector<Ray> rays(16, down);
  rays[1].direction.x() = kNan;
  rays[2].origin_m.y() = kNan;
  rays[3].from_m = kNan;
  rays[4].to_m = kNan;
  rays[5].direction.z() = std::numeric_limits<float>::infinity();
  rays[6].origin_m.x() = 1e30f;
  rays[7].from_m = 9.0f, rays[7].to_m = 8.0f;
  rays[8].direction.setZero();
  rays[9].to_m = -1.0f;
  std::vector<RayHit> hits(rays.size());
  sensors.Trace(rays.data(), rays.size(), kSeesAll, SensorScene::kNoAgent, hits.data());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const bool is_ray = i < 1 || i > 9;
    EXPECT_EQ(hits[i].target, is_ray ? RayTarget::kGround : RayTarget::kNothing) << i;
    EXPECT_EQ(sensors.IsBlocked(rays[i], kSeesAll, SensorScene::kNoAgent), is_ray) << i;
  }
  // One that begins behind its origin begins there.
  Ray back = down;
  back.from_m = -3.0f;
  EXPECT_NEAR(TraceOne(sensors, back).distance_m, 4.0f, 1e-4f);
}

TEST(SensorSceneTest, TreesThatTheWorldHasNotAreAnErrorThatChangesNothing) {
  SensorScene sensors = SensorsOf(Plain({MakeTree(0.0f, 0.0f, 12.0f, 3.0f, 0.3f)}));
  SensedWorld world;
  world.props = {MakeProp(PropKind::kCrate, {2.0, 1.0, 1.0}, {6.0, 6.0, 1.0})};
  ASSERT_TRUE(sensors.Update(world).ok());
  world.props.clear();
  world.felled = {{1, {0.0, 0.0, 1.0}, {1.0, 0.0, 1.0}}};
  const Status status = sensors.Update(world);
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_NE(status.message().find("1 asset"), std::string::npos) << status.message();
  EXPECT_EQ(TraceOne(sensors, MakeRay({0.0f, 6.0f, 1.5f}, Vector3f::UnitX())).target,
            RayTarget::kProp);
}

TEST(SensorSceneTest, OptionsOutOfRangeAreErrors) {
  for (const double tile_m : {0.0, 3.9, 5000.0, std::numeric_limits<double>::quiet_NaN()}) {
    SensorSceneOptions options;
    options.tile_m = tile_m;
    EXPECT_EQ(SensorScene::Create(Plain(), options, Progress()).status().code(),
              StatusCode::kInvalidArgument);
  }
  SensorSceneOptions options;
  options.threads = -1;
  EXPECT_FALSE(SensorScene::Create(Plain(), options, Progress()).ok());
  Progress cancelled;
  cancelled.Cancel();
  EXPECT_EQ(SensorScene::Create(Plain({MakeTree(0.0f, 0.0f, 12.0f, 3.0f, 0.3f)}),
                                SensorSceneOptions(), cancelled)
                .status()
                .code(),
            StatusCode::kCancelled);
}

}  // namespace
}  // namespace latticeworld
