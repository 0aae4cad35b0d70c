#include "latticeworld/sensing/lidar/lidar_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/sensing/sensed_world.h"
#include "latticeworld/sensing/sensor_scene.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

Atmosphere Air(double snow_depth_m, double wind_mps) {
  Atmosphere atmosphere;
  atmosphere.snow_depth_m = snow_depth_m;
  atmosphere.wind_mps.x() = wind_mps;
  return atmosphere;
}

Scene Grove() {
  std::vector<Asset> trees;
  for (int i = 0; i < 4; ++i)
    trees.push_back(MakeTree(5.0f * static_cast<float>(i) - 8.0f, 3.0f, 8.0f, 2.0f, 0.2f));
  return WithAssets(MakeScene(64, 64.0, [](double x_m, double) { return 0.1 * x_m; }), trees);
}

// The most that a thousand rays from above bring back, told from `surfaces`.
float MostReturned(const Scene& world, const LidarSurfaces& surfaces) {
  const auto scene = std::make_shared<const Scene>(world);
  const SensorScene rays = SensorScene::Create(scene, SensorSceneOptions(), Progress()).value();
  RandomStream random(1, "rays");
  float most = 0.0f;
  for (int i = 0; i < 1000; ++i) {
    Ray ray;
    ray.origin_m = Eigen::Vector3d(random.Uniform(-15.0, 15.0), random.Uniform(-15.0, 15.0), 30.0)
                       .cast<float>();
    ray.direction = Eigen::Vector3d(random.Uniform(-0.3, 0.3), random.Uniform(-0.3, 0.3), -1.0)
                        .normalized()
                        .cast<float>();
    RayHit hit;
    rays.Trace(&ray, 1, kSeesAll, SensorScene::kNoAgent, &hit);
    if (hit.target == RayTarget::kNothing) continue;
    most = std::max(most, surfaces.Return(ray, hit, SensedWorld()));
  }
  return most;
}

TEST(LidarSurfacesTest, NothingReturnsMoreThanTheMost) {
  const Scene grove = Grove(), lake = WithWater(Grove(), 0.5f);
  for (const Scene* world : {&grove, &lake}) {
    LidarSurfaces surfaces(std::make_shared<const Scene>(*world));
    for (const double snow_depth_m : {0.0, 0.2}) {
      for (const double wind_mps : {0.0, 15.0}) {
        surfaces.SetWeather(Air(snow_depth_m, wind_mps));
        const float most = MostReturned(*world, surfaces);
        EXPECT_GT(most, 0.1f);
        EXPECT_LE(most, surfaces.MostReturned(SensedWorld()));
      }
    }
  }
}

TEST(LidarSurfacesTest, TheMostIsOfWhatTheWorldHas) {
  LidarSurfaces dry(std::make_shared<const Scene>(Grove()));
  dry.SetWeather(Air(0.0, 0.0));
  const float without_snow = dry.MostReturned(SensedWorld());
  EXPECT_LT(without_snow, 0.8f);
  dry.SetWeather(Air(0.2, 0.0));
  EXPECT_FLOAT_EQ(dry.MostReturned(SensedWorld()), 0.8f);  // of coarse snow
  LidarSurfaces lake(std::make_shared<const Scene>(WithWater(Grove(), 0.5f)));
  lake.SetWeather(Air(0.0, 0.0));
  EXPECT_GT(lake.MostReturned(SensedWorld()), 1.0f);  // smooth water mirrors
  lake.SetWeather(Air(0.0, 15.0));
  EXPECT_FLOAT_EQ(lake.MostReturned(SensedWorld()), without_snow);
}

}  // namespace
}  // namespace latticeworld
