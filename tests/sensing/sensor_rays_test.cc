// The same hits by whichever way.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/parallel.h"
#include "latticeworld/common/random.h"
#include "latticeworld/meshes/mesh.h"
#include "latticeworld/scene/scene_changes.h"
#include "latticeworld/sensing/sensor_scene.h"
#include "latticeworld/sensing/solids/asset_meshes.h"
#include "mapping/hand_made_scene.h"
#include "sensing/sensed_things.h"

namespace latticeworld {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kSize_m = 96.0;

// Rough land with water in its hollows and things of every sort.
std::shared_ptr<const Scene> Thicket(std::uint64_t seed) {
  RandomStream random(seed, "thicket");
  std::vector<Asset> assets;
  for (int i = 0; i < 60; ++i) {
    const auto at = [&] { return static_cast<float>(random.Uniform(-46.0, 46.0)); };
    const float x_m = at(), y_m = at();
    const auto size = static_cast<float>(random.Uniform(0.6, 1.4));
    switch (i % 5) {
      case 0:
        assets.push_back(MakeRound(AssetKind::kStone, x_m, y_m, size, size));
        break;
      case 1:
        assets.push_back(MakeBuilding(x_m, y_m, 5.0f * size, 4.0f, 3.0f, 3.0f * size));
        break;
      case 2:
        assets.push_back(MakeRound(AssetKind::kBush, x_m, y_m, 1.5f * size, size));
        break;
      default:
        assets.push_back(MakeTree(x_m, y_m, 10.0f * size, 3.0f * size, 0.2f));
    }
    assets.back().yaw_rad = 3.0f * size;
  }
  return std::make_shared<Scene>(WithAssets(WithWater(MakeScene(96, kSize_m,
                                                                [&](double x_m, double y_m) {
                                                                  return 2.0 * std::sin(0.1 * x_m) *
                                                                         std::cos(0.13 * y_m);
                                                                }),
                                                      -1.0f),
                                            std::move(assets)));
}

SensedWorld Crowd(std::uint64_t seed) {
  RandomStream random(seed, "crowd");
  const auto place = [&] {
    return Vector3d(random.Uniform(-30.0, 30.0), random.Uniform(-30.0, 30.0),
                    random.Uniform(-1.0, 3.0));
  };
  SensedWorld world;
  for (int i = 0; i < 20; ++i) world.agents.push_back(MakeRobot(place(), 0.3 * i));
  for (int i = 0; i < 5; ++i)
    world.props.push_back(MakeProp(PropKind::kCrate, {1.0, 2.0, 1.0}, place(), 0.7 * i));
  world.felled = {{3, place(), place()}, {8, place(), place()}};
  world.gone = {4};
  return world;
}

// Some side by side, some anywhere.
std::vector<Ray> RaysOf(std::uint64_t seed, int count) {
  RandomStream random(seed, "rays");
  std::vector<Ray> rays;
  Vector3f origin_m, direction;
  for (int i = 0; i < count; ++i) {
    const auto draw = [&](double reach) {
      return static_cast<float>(random.Uniform(-reach, reach));
    };
    if (i % 16 == 0 || i > count / 2) {
      origin_m = {draw(40.0), draw(40.0), 4.0f + draw(3.0)};
      direction = {draw(1.0), draw(1.0), draw(0.5)};
    }
    rays.push_back(MakeRay(origin_m, direction + Vector3f(draw(0.05), draw(0.05), draw(0.05))));
    if (i % 3 == 0) rays.back().to_m = 20.0f;
  }
  return rays;
}

SensorScene SensorsOf(const std::shared_ptr<const Scene>& scene, SensorSceneOptions options,
                      bool baked) {
  options.medium_within_m = std::numeric_limits<double>::infinity();
  if (!baked) options.max_baked_triangles = 0;
  SensorScene sensors = SensorScene::Create(scene, options, Progress()).value();
  EXPECT_TRUE(sensors.Focus({Vector3d::Zero()}).ok());
  return sensors;
}

std::vector<RayHit> HitsOf(const SensorScene& sensors, const std::vector<Ray>& rays,
                           RaySights sights = kSeesAll,
                           std::uint32_t except_agent = SensorScene::kNoAgent) {
  std::vector<RayHit> hits(rays.size());
  sensors.Trace(rays.data(), rays.size(), sights, except_agent, hits.data());
  return hits;
}

bool IsSame(const RayHit& a, const RayHit& b, float tolerance_m, float tolerance_normal) {
  if (a.target != b.target || a.index != b.index || a.part != b.part) return false;
  if (a.target == RayTarget::kNothing) return a.distance_m == b.distance_m;
  return std::abs(a.distance_m - b.distance_m) <= tolerance_m &&
         (a.normal - b.normal).norm() <= tolerance_normal;
}

// How many are not the same up to rounding: rays that graze an edge may pass it on either side.
int Differing(const std::vector<RayHit>& a, const std::vector<RayHit>& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += IsSame(a[i], b[i], 1e-3f, 1e-2f) ? 0 : 1;
  return count;
}

std::string Differences(const std::vector<RayHit>& a, const std::vector<RayHit>& b) {
  std::string all;
  const auto text = [](const RayHit& hit) {
    return std::to_string(static_cast<int>(hit.target)) + " " + std::to_string(hit.index) + " " +
           std::to_string(hit.part) + " at " + std::to_string(hit.distance_m) + " normal z " +
           std::to_string(hit.normal.z());
  };
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!IsSame(a[i], b[i], 1e-3f, 1e-2f))
      all += "\n" + std::to_string(i) + ": " + text(a[i]) + " and " + text(b[i]);
  }
  return all;
}

TEST(SensorRaysTest, HitsAreThoseOfTheRaySceneWhicheverTilesAreBaked) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const auto scene = Thicket(seed);
    const SensedWorld crowd = Crowd(seed);
    SensedWorld world;  // what the rays' scene has too
    world.felled = crowd.felled;
    world.gone = crowd.gone;
    SceneChanges changes;
    changes.fallen = world.felled;
    changes.gone = world.gone;
    RaySceneOptions ray_options;
    ray_options.changes = &changes;
    const RayScene expected = RayScene::Create(*scene, ray_options, Progress()).value();
    const std::vector<Ray> rays = RaysOf(seed, 3000);
    for (const RaySights sights : {kSeesSolid, kSeesAll}) {
      std::vector<RayHit> one_by_one;
      for (const Ray& ray : rays) one_by_one.push_back(expected.Trace(ray, sights));
      for (const double baked_within_m : {0.0, 30.0, 1000.0}) {
        SensorSceneOptions options;
        options.baked_within_m = baked_within_m;
        SensorScene sensors = SensorsOf(scene, options, true);
        ASSERT_TRUE(sensors.Update(world).ok());
        const std::vector<RayHit> hits = HitsOf(sensors, rays, sights);
        EXPECT_LE(Differing(hits, one_by_one), 3)
            << seed << " " << baked_within_m << Differences(hits, one_by_one);
      }
    }
  }
}

// Points on edges and corners of the asset's triangles that are turned towards the eye.
std::vector<Vector3f> SeamsOf(const Scene& scene, const Asset& asset, int detail,
                              const Vector3f& eye_m, RandomStream* random) {
  const Mesh mesh =
      BuildMesh(scene.catalogue->models()[asset.model], 1.0, detail, MeshVariationOf(asset));
  const Eigen::Matrix<float, 3, 4> map_from_mesh = MapFromMesh(StandingInstance(asset, 0));
  std::vector<Vector3f> points;
  for (const Vector3f& vertex : mesh.vertices)
    points.push_back(map_from_mesh.leftCols<3>() * vertex + map_from_mesh.col(3));
  // By their ends: how many triangles meet in it, all of them turned towards the eye.
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3f normal = (points[b] - points[a]).cross(points[c] - points[a]).normalized();
    if (normal.dot((eye_m - points[a]).normalized()) < 0.05f) continue;
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      ++edges[std::minmax(from, to)];
  }
  std::vector<Vector3f> seams;
  for (const auto& [ends, triangles] : edges) {
    if (triangles != 2) continue;
    const Vector3f &from_m = points[ends.first], &to_m = points[ends.second];
    for (int i = 0; i < 20; ++i)
      seams.push_back(from_m + static_cast<float>(random->Uniform()) * (to_m - from_m));
  }
  return seams;
}

TEST(SensorRaysTest, NothingSlipsBetweenTheTrianglesOfStones) {
  RandomStream random(3, "seams");
  for (int i = 0; i < 20; ++i) {
    Asset stone = MakeRound(AssetKind::kStone, static_cast<float>(random.Uniform(-3.0, 3.0)),
                            static_cast<float>(random.Uniform(-3.0, 3.0)), 2.0f, 1.5f);
    stone.yaw_rad = static_cast<float>(random.Uniform(-3.0, 3.0));
    const auto scene = std::make_shared<Scene>(
        WithAssets(MakeScene(96, kSize_m, [](double, double) { return 0.0; }), {stone}));
    const SensorScene sensors = SensorsOf(scene, {}, true);
    const Vector3f eye_m(15.0f, static_cast<float>(random.Uniform(-9.0, 9.0)), 4.0f);
    std::vector<Ray> rays;
    std::vector<float> seams_m;
    for (const Vector3f& seam_m : SeamsOf(*scene, scene->assets[0], 1, eye_m, &random)) {
      rays.push_back(MakeRay(eye_m, seam_m - eye_m));
      seams_m.push_back((seam_m - eye_m).norm());
    }
    ASSERT_GT(rays.size(), 100u);
    const std::vector<RayHit> hits = HitsOf(sensors, rays);
    for (std::size_t k = 0; k < rays.size(); ++k)
      EXPECT_LE(hits[k].distance_m, seams_m[k] + 1e-3f) << i << " " << k;
  }
}

TEST(SensorRaysTest, ARayMeetsTheSameAloneAsAmongOthers) {
  for (const bool baked : {false, true}) {
    SensorScene sensors = SensorsOf(Thicket(7), {}, baked);
    ASSERT_TRUE(sensors.Update(Crowd(7)).ok());
    const std::vector<Ray> rays = RaysOf(7, 3000);
    const std::vector<RayHit> together = HitsOf(sensors, rays, kSeesAll, 2);
    std::vector<RayHit> alone(rays.size());
    std::vector<float> distances_m(rays.size());
    sensors.TraceDistances(rays.data(), rays.size(), kSeesAll, 2, distances_m.data());
    int differently_blocked = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      sensors.Trace(&rays[i], 1, kSeesAll, 2, &alone[i]);
      EXPECT_EQ(distances_m[i], together[i].distance_m);
      const bool blocked = sensors.IsBlocked(rays[i], kSeesAll, 2);
      differently_blocked += blocked == (together[i].target != RayTarget::kNothing) ? 0 : 1;
    }
    EXPECT_LE(Differing(together, alone), 1);
    EXPECT_LE(differently_blocked, 1);
  }
}

TEST(SensorRaysTest, ThreadsTraceAndBuildTheSame) {
  const auto scene = Thicket(8);
  const std::vector<Ray> rays = RaysOf(8, 3200);
  SensorScene sensors = SensorsOf(scene, {}, true);
  ASSERT_TRUE(sensors.Update(Crowd(8)).ok());
  const std::vector<RayHit> hits = HitsOf(sensors, rays);
  SensorSceneOptions options;
  options.threads = 4;
  SensorScene threaded = SensorsOf(scene, options, true);
  ASSERT_TRUE(threaded.Update(Crowd(8)).ok());
  std::vector<RayHit> more(rays.size());
  ParallelFor(100, 4, [&](int begin, int end) {
    threaded.Trace(&rays[32 * begin], 32 * (end - begin), kSeesAll, SensorScene::kNoAgent,
                   &more[32 * begin]);
  });
  EXPECT_LE(Differing(hits, more), 1);
}

TEST(SensorRaysTest, WhatWasLookedAtBeforeChangesNoHit) {
  const auto scene = Thicket(9);
  SensorSceneOptions options;
  options.tile_m = 8.0;
  options.baked_within_m = 20.0;
  options.medium_within_m = 12.0;
  options.finest_within_m = 1.0;
  options.max_baked_triangles = 40000;  // too few for all of the places
  const std::vector<Ray> rays = RaysOf(9, 2000);
  const std::vector<Vector3d> here = {{-10.0, 3.0, 0.0}, {20.0, 20.0, 0.0}};
  SensorScene fresh = SensorScene::Create(scene, options, Progress()).value();
  ASSERT_TRUE(fresh.Update(Crowd(9)).ok());
  ASSERT_TRUE(fresh.Focus(here).ok());
  SensorScene travelled = SensorScene::Create(scene, options, Progress()).value();
  RandomStream random(9, "travels");
  for (int i = 0; i < 12; ++i) {
    ASSERT_TRUE(travelled.Update(i % 3 == 0 ? SensedWorld() : Crowd(i)).ok());
    ASSERT_TRUE(
        travelled.Focus({{random.Uniform(-40.0, 40.0), random.Uniform(-40.0, 40.0), 0.0}}).ok());
  }
  ASSERT_TRUE(travelled.Focus(here).ok());
  ASSERT_TRUE(travelled.Update(Crowd(9)).ok());
  const std::vector<RayHit> a = HitsOf(fresh, rays), b = HitsOf(travelled, rays);
  for (std::size_t i = 0; i < rays.size(); ++i) EXPECT_TRUE(IsSame(a[i], b[i], 0.0f, 0.0f)) << i;
}

TEST(SensorRaysTest, DetailsGoByTheNearestPlaceThatIsLookedFrom) {
  const auto scene = std::make_shared<Scene>(
      WithAssets(MakeScene(96, kSize_m, [](double, double) { return 0.0; }),
                 {MakeTree(4.0f, 4.0f, 10.0f, 3.0f, 0.2f), MakeTree(20.0f, 4.0f, 10.0f, 3.0f, 0.2f),
                  MakeTree(-40.0f, -40.0f, 10.0f, 3.0f, 0.2f)}));
  SensorSceneOptions options;
  options.tile_m = 8.0;
  options.finest_within_m = 10.0;
  options.medium_within_m = 30.0;
  SensorScene sensors = SensorScene::Create(scene, options, Progress()).value();
  const auto detail_of = [&](int tree) {
    // The one whose hits are the tree's.
    const Asset& asset = scene->assets[tree];
    std::vector<Ray> rays;
    for (int i = 0; i < 400; ++i) {
      rays.push_back(MakeRay({asset.x_m - 3.0f + 0.3f * static_cast<float>(i % 20),
                              asset.y_m - 3.0f + 0.3f * static_cast<float>(i / 20), 20.0f},
                             -Vector3f::UnitZ()));
    }
    const std::vector<RayHit> hits = HitsOf(sensors, rays);
    for (int detail = 0; detail < 3; ++detail) {
      RaySceneOptions ray_options;
      ray_options.detail = detail;
      const RayScene expected = RayScene::Create(*scene, ray_options, Progress()).value();
      std::vector<RayHit> wanted;
      for (const Ray& ray : rays) wanted.push_back(expected.Trace(ray, kSeesAll));
      if (Differing(hits, wanted) <= 2) return detail;
    }
    return -1;
  };
  EXPECT_EQ(detail_of(0), 2);
  ASSERT_TRUE(sensors.Focus({{4.0, 4.0, 0.0}}).ok());
  EXPECT_EQ(detail_of(0), 0);
  EXPECT_EQ(detail_of(1), 1);
  EXPECT_EQ(detail_of(2), 2);
  ASSERT_TRUE(sensors.Focus({{-40.0, -40.0, 0.0}, {20.0, 4.0, 0.0}}).ok());
  EXPECT_EQ(detail_of(0), 1);
  EXPECT_EQ(detail_of(1), 0);
  EXPECT_EQ(detail_of(2), 0);
}

}  // namespace
}  // namespace latticeworld
