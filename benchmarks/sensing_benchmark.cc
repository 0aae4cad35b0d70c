// What sensors pay for their rays, over a kilometre of wood with 100,000 trees.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include "latticeworld/common/parallel.h"
#include "latticeworld/common/random.h"
#include "latticeworld/sensing/asset_tiles.h"
#include "latticeworld/sensing/sensed_world.h"
#include "latticeworld/sensing/sensor_scene.h"
#include "latticeworld/sensing/surface_geometry.h"
#include "sensing_rays.h"
#include "wood.h"

namespace latticeworld {
namespace {

enum Sensor { kLidar = 0, kDepth = 1 };

Eigen::Vector3f Eye() {
  const double ground_m = KilometreOfWood()->terrain->ground.HeightAt({0.3, 0.2});
  return Eigen::Vector3f(0.3f, 0.2f, static_cast<float>(ground_m) + 1.2f);
}

const std::vector<Ray>& RaysOf(Sensor sensor) {
  static const std::vector<Ray> lidar = LidarRays(Eye()), depth = DepthRays(Eye());
  return sensor == kLidar ? lidar : depth;
}

SensorSceneOptions Options(bool baked) {
  SensorSceneOptions options;
  if (!baked) options.max_baked_triangles = 0;
  return options;
}

SensedWorld Agents(int count) {
  SensedWorld world;
  RandomStream random(3, "agents");
  const HeightField& ground = KilometreOfWood()->terrain->ground;
  for (int i = 0; i < count; ++i) {
    SensedAgent agent;
    const WorldPoint at = {random.Uniform(-50.0, 50.0), random.Uniform(-50.0, 50.0)};
    agent.map_from_base = Eigen::Translation3d(at.x_m, at.y_m, ground.HeightAt(at)) *
                          Eigen::AngleAxisd(random.Uniform(0.0, 6.0), Eigen::Vector3d::UnitZ());
    world.agents.push_back(agent);
  }
  return world;
}

SensorScene* Sensors(bool baked) {
  static SensorScene scenes[] = {
      SensorScene::Create(KilometreOfWood(), Options(false), Progress()).value(),
      SensorScene::Create(KilometreOfWood(), Options(true), Progress()).value()};
  SensorScene* scene = &scenes[baked ? 1 : 0];
  benchmark::DoNotOptimize(scene->Focus({Eye().cast<double>()}));
  return scene;
}

void CountRays(benchmark::State& state, std::size_t rays) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays));
}

// sensor, baked near the eye, what is answered (0: distances, 1: hits).
void BM_Trace(benchmark::State& state) {
  const std::vector<Ray>& rays = RaysOf(static_cast<Sensor>(state.range(0)));
  const SensorScene& scene = *Sensors(state.range(1) != 0);
  std::vector<RayHit> hits(rays.size());
  std::vector<float> distances_m(rays.size());
  for (auto _ : state) {
    if (state.range(2) != 0) {
      scene.Trace(rays.data(), rays.size(), kSeesAll, SensorScene::kNoAgent, hits.data());
      benchmark::DoNotOptimize(hits.data());
    } else {
      scene.TraceDistances(rays.data(), rays.size(), kSeesAll, SensorScene::kNoAgent,
                           distances_m.data());
      benchmark::DoNotOptimize(distances_m.data());
    }
  }
  CountRays(state, rays.size());
}
BENCHMARK(BM_Trace)
    ->ArgNames({"depth", "baked", "hits"})
    ->ArgsProduct({{0, 1}, {0, 1}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

// The same scenes without our layer: packets are ready, and nothing is told of what is met.
void BM_BareEmbree(benchmark::State& state) {
  static const EmbreeDevice device(rtcNewDevice("threads=1"));
  static const EmbreeScene ground = [] {
    EmbreeScene scene(rtcNewScene(device.get()));
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    rtcAttachGeometry(scene.get(),
                      GroundGeometry(device.get(), KilometreOfWood()->terrain->ground).get());
    rtcCommitScene(scene.get());
    return scene;
  }();
  const auto tiles =
      AssetTiles::Create(device.get(), *KilometreOfWood(), Options(state.range(1) != 0), Progress())
          .value();
  benchmark::DoNotOptimize(tiles->Focus({Eye().cast<double>()}));
  const auto packets = PacketsOf(RaysOf(static_cast<Sensor>(state.range(0))));
  alignas(64) int valid[16];
  std::fill(valid, valid + 16, -1);
  RTCIntersectContext context = CoherentContext();
  for (auto _ : state) {
    for (const RTCRayHit16& packet : packets) {
      alignas(64) RTCRayHit16 rays = packet;
      std::fill(rays.hit.geomID, rays.hit.geomID + 16, RTC_INVALID_GEOMETRY_ID);
      rtcIntersect16(valid, tiles->scene(), &context, &rays);
      rtcIntersect16(valid, ground.get(), &context, &rays);
      benchmark::DoNotOptimize(rays.ray.tfar);
    }
  }
  CountRays(state, 16 * packets.size());
}
BENCHMARK(BM_BareEmbree)
    ->ArgNames({"depth", "baked"})
    ->ArgsProduct({{0, 1}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

void BM_RayMarch(benchmark::State& state) {
  const std::vector<Ray>& rays = RaysOf(static_cast<Sensor>(state.range(0)));
  const RayMarch march(*KilometreOfWood(), Eye(), rays.front().to_m);
  constexpr std::size_t kEvery = 97;
  for (auto _ : state) {
    for (std::size_t i = 0; i < rays.size(); i += kEvery)
      benchmark::DoNotOptimize(march.Distance(rays[i]));
  }
  CountRays(state, (rays.size() + kEvery - 1) / kEvery);
}
BENCHMARK(BM_RayMarch)->ArgNames({"depth"})->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

// A revolution and a picture, of a robot among others. core_at_10_hz: share of one core.
void BM_LidarAndDepth(benchmark::State& state) {
  SensorScene* scene = Sensors(true);
  const SensedWorld world = Agents(static_cast<int>(state.range(0)));
  std::vector<RayHit> hits(RaysOf(kDepth).size());
  for (auto _ : state) {
    benchmark::DoNotOptimize(scene->Update(world));
    for (const Sensor sensor : {kLidar, kDepth}) {
      const std::vector<Ray>& rays = RaysOf(sensor);
      scene->Trace(rays.data(), rays.size(), kSeesAll, 0, hits.data());
      benchmark::DoNotOptimize(hits.data());
    }
  }
  benchmark::DoNotOptimize(scene->Update(SensedWorld()));
  state.counters["core_at_10_hz"] =
      benchmark::Counter(0.1 * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(BM_LidarAndDepth)->ArgNames({"agents"})->Arg(0)->Arg(100)->Unit(benchmark::kMillisecond);

void BM_TraceInThreads(benchmark::State& state) {
  const std::vector<Ray>& rays = RaysOf(kDepth);
  const SensorScene& scene = *Sensors(true);
  std::vector<RayHit> hits(rays.size());
  for (auto _ : state) {
    constexpr int kStrips = 120;
    const std::size_t strip = rays.size() / kStrips;
    ParallelFor(kStrips, static_cast<int>(state.range(0)), [&](int begin, int end) {
      scene.Trace(&rays[begin * strip], (end - begin) * strip, kSeesAll, SensorScene::kNoAgent,
                  &hits[begin * strip]);
    });
    benchmark::DoNotOptimize(hits.data());
  }
  CountRays(state, rays.size());
}
BENCHMARK(BM_TraceInThreads)
    ->ArgNames({"threads"})
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void BM_Update(benchmark::State& state) {
  SensorScene* scene = Sensors(false);
  SensedWorld world = Agents(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    for (SensedAgent& agent : world.agents) agent.map_from_base.translation().x() += 0.01;
    benchmark::DoNotOptimize(scene->Update(world));
  }
  benchmark::DoNotOptimize(scene->Update(SensedWorld()));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(BM_Update)->ArgNames({"agents"})->Arg(100)->Arg(1000)->Unit(benchmark::kMicrosecond);

// A robot comes into the next tile, where it has not been.
void BM_FocusOnANewTile(benchmark::State& state) {
  SensorScene scene = SensorScene::Create(KilometreOfWood(), Options(true), Progress()).value();
  double x_m = -400.0;
  benchmark::DoNotOptimize(scene.Focus({{x_m, 0.0, 0.0}}));
  for (auto _ : state) {
    x_m += Options(true).tile_m;
    benchmark::DoNotOptimize(scene.Focus({{x_m, 0.0, 0.0}}));
  }
}
BENCHMARK(BM_FocusOnANewTile)->Iterations(8)->Unit(benchmark::kMillisecond);

void BM_MakeSensorScene(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(
        SensorScene::Create(KilometreOfWood(), Options(true), Progress()).ok());
}
BENCHMARK(BM_MakeSensorScene)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace latticeworld
