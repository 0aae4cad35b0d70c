// What sensors pay for their rays, over a kilometre of wood with 100,000 trees.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include "latticeworld/common/parallel.h"
#include "latticeworld/common/random.h"
#include "latticeworld/sensing/camera/camera_renderer.h"
#include "latticeworld/sensing/lidar/lidar_caster.h"
#include "latticeworld/sensing/sensed_world.h"
#include "latticeworld/sensing/sensor_scene.h"
#include "latticeworld/sensing/sensor_suite.h"
#include "latticeworld/sensing/solids/asset_tiles.h"
#include "latticeworld/sensing/solids/surface_geometry.h"
#include "sensing_rays.h"
#include "wood.h"

namespace latticeworld {
namespace {

enum Sensor { kLidar = 0, kDepth = 1 };

// Sensors here and there in the wood: how many crowns one looks through differs by half. Figures
// are of all of them together, or of one in the mean where it says so.
constexpr int kEyes = 4;

std::vector<Eigen::Vector3d> Eyes() {
  RandomStream random(5, "eyes");
  std::vector<Eigen::Vector3d> eyes_m;
  for (int i = 0; i < kEyes; ++i) {
    const WorldPoint at = {random.Uniform(-200.0, 200.0), random.Uniform(-200.0, 200.0)};
    eyes_m.emplace_back(at.x_m, at.y_m, KilometreOfWood()->terrain->ground.HeightAt(at) + 1.2);
  }
  return eyes_m;
}

// Of one eye after the other.
std::vector<Ray> RaysFromAll(Sensor sensor) {
  std::vector<Ray> rays;
  for (const Eigen::Vector3d& eye_m : Eyes()) {
    const std::vector<Ray> own =
        sensor == kLidar ? LidarRays(eye_m.cast<float>()) : DepthRays(eye_m.cast<float>());
    rays.insert(rays.end(), own.begin(), own.end());
  }
  return rays;
}

const std::vector<Ray>& RaysOf(Sensor sensor) {
  static const std::vector<Ray> lidar = RaysFromAll(kLidar), depth = RaysFromAll(kDepth);
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
    const WorldPoint at = {random.Uniform(-200.0, 200.0), random.Uniform(-200.0, 200.0)};
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
  benchmark::DoNotOptimize(scene->Focus(Eyes()));
  return scene;
}

void CountRays(benchmark::State& state, std::size_t rays) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays));
}

// Seconds that one sensor takes in the mean.
void CountSensors(benchmark::State& state) {
  state.counters["a_sensor"] =
      benchmark::Counter(kEyes * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
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
  CountSensors(state);
}
BENCHMARK(BM_Trace)
    ->ArgNames({"depth", "baked", "hits"})
    ->ArgsProduct({{0, 1}, {0, 1}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

RTCDevice Device() {
  static const EmbreeDevice device(rtcNewDevice("threads=1"));
  return device.get();
}

EmbreeScene SceneOf(const EmbreeGeometry& geometry) {
  EmbreeScene scene(rtcNewScene(Device()));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  rtcAttachGeometry(scene.get(), geometry.get());
  rtcCommitScene(scene.get());
  return scene;
}

// Packets that are ready, and nothing is told of what is met.
void TraceBare(benchmark::State& state, RTCScene trees) {
  static const EmbreeScene ground =
      SceneOf(GroundGeometry(Device(), KilometreOfWood()->terrain->ground));
  const auto packets = PacketsOf(RaysOf(static_cast<Sensor>(state.range(0))));
  alignas(64) int valid[16];
  std::fill(valid, valid + 16, -1);
  RTCIntersectContext context = CoherentContext();
  for (auto _ : state) {
    for (const RTCRayHit16& packet : packets) {
      alignas(64) RTCRayHit16 rays = packet;
      std::fill(rays.hit.geomID, rays.hit.geomID + 16, RTC_INVALID_GEOMETRY_ID);
      rtcIntersect16(valid, trees, &context, &rays);
      rtcIntersect16(valid, ground.get(), &context, &rays);
      benchmark::DoNotOptimize(rays.ray.tfar);
    }
  }
  CountRays(state, 16 * packets.size());
  CountSensors(state);
}

// The same scenes without our layer.
void BM_BareEmbree(benchmark::State& state) {
  const auto tiles =
      AssetTiles::Create(Device(), *KilometreOfWood(), Options(state.range(1) != 0), Progress())
          .value();
  benchmark::DoNotOptimize(tiles->Focus(Eyes()));
  TraceBare(state, tiles->scene());
}
BENCHMARK(BM_BareEmbree)
    ->ArgNames({"depth", "baked"})
    ->ArgsProduct({{0, 1}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

// Solid trees of 50 triangles in one mesh: how fast the machine is, and what leaves cost.
void BM_BareSolidTrees(benchmark::State& state) {
  static const EmbreeScene trees = SceneOf(SolidTrees(Device(), *KilometreOfWood()));
  TraceBare(state, trees.get());
}
BENCHMARK(BM_BareSolidTrees)->ArgNames({"depth"})->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

// The wood without the trees that are further from every eye than so many metres: the least that
// they can cost, whatever takes their place.
void BM_NoFarTrees(benchmark::State& state) {
  const auto near_m = static_cast<double>(state.range(1));
  const std::vector<Eigen::Vector3d> eyes_m = Eyes();
  auto wood = std::make_shared<Scene>();
  wood->terrain = KilometreOfWood()->terrain;
  wood->catalogue = KilometreOfWood()->catalogue;
  for (const Asset& tree : KilometreOfWood()->assets) {
    const bool near = std::any_of(eyes_m.begin(), eyes_m.end(), [&](const Eigen::Vector3d& eye_m) {
      return std::hypot(tree.x_m - eye_m.x(), tree.y_m - eye_m.y()) < near_m;
    });
    if (near) wood->assets.push_back(tree);
  }
  wood->index = AssetIndex(wood->terrain->ground.geometry().size_m(), wood->assets);
  SensorScene scene = SensorScene::Create(wood, Options(true), Progress()).value();
  benchmark::DoNotOptimize(scene.Focus(eyes_m));
  const std::vector<Ray>& rays = RaysOf(static_cast<Sensor>(state.range(0)));
  std::vector<float> distances_m(rays.size());
  for (auto _ : state) {
    scene.TraceDistances(rays.data(), rays.size(), kSeesAll, SensorScene::kNoAgent,
                         distances_m.data());
    benchmark::DoNotOptimize(distances_m.data());
  }
  CountRays(state, rays.size());
  CountSensors(state);
}
BENCHMARK(BM_NoFarTrees)
    ->ArgNames({"depth", "near_m"})
    ->ArgsProduct({{0, 1}, {0, 4, 8, 12, 16, 24, 1000}})
    ->Unit(benchmark::kMillisecond);

void BM_RayMarch(benchmark::State& state) {
  // Of the first eye.
  const std::vector<Ray>& rays = RaysOf(static_cast<Sensor>(state.range(0)));
  const std::size_t count = rays.size() / kEyes;
  const RayMarch march(*KilometreOfWood(), rays.front().origin_m, rays.front().to_m);
  constexpr std::size_t kEvery = 97;
  for (auto _ : state) {
    for (std::size_t i = 0; i < count; i += kEvery)
      benchmark::DoNotOptimize(march.Distance(rays[i]));
  }
  CountRays(state, (count + kEvery - 1) / kEvery);
}
BENCHMARK(BM_RayMarch)->ArgNames({"depth"})->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

// A revolution and a picture of each robot, among others. core_at_10_hz: share of one core that a
// robot takes in the mean.
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
      benchmark::Counter(0.1 * kEyes * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(BM_LidarAndDepth)->ArgNames({"agents"})->Arg(0)->Arg(100)->Unit(benchmark::kMillisecond);

// The same as readings of the lidar and the camera of the suite "survey": echoes with their noise,
// points, depth.
void BM_LidarAndDepthReadings(benchmark::State& state) {
  const SensorScene& scene = *Sensors(true);
  const SensedWorld world;
  const LidarModel& model = *SensorCatalogue::BuiltIn()->FindLidar("ouster os1-64");
  const LidarCaster caster(model, 10.0);
  const LidarSurfaces surfaces(KilometreOfWood());
  const LidarReceiver receiver(model, world.atmosphere);
  LidarCast cast;
  cast.scene = &scene;
  cast.surfaces = &surfaces;
  cast.receiver = &receiver;
  cast.world = &world;
  CameraModel camera;
  camera.width = 640;
  camera.height = 480;
  camera.fx_px = camera.fy_px = 320.0;
  camera.cx_px = 319.5;
  camera.cy_px = 239.5;
  camera.depth_noise = 0.001;
  const CameraRenderer renderer(camera);
  CameraOutputs outputs;
  outputs.depth = true;
  Eigen::Matrix3d map_from_optical;
  map_from_optical << 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0;
  for (auto _ : state) {
    for (const Eigen::Vector3d& eye_m : Eyes()) {
      std::vector<ColumnPose> poses(caster.columns());
      for (int i = 0; i < caster.columns(); ++i) {
        poses[i].column = i;
        poses[i].origin_m = eye_m.cast<float>();
      }
      LidarSweep sweep = caster.Begin(0.0, 0.1);
      caster.Fire(cast, poses, &sweep);
      caster.AddPoints(&sweep);
      benchmark::DoNotOptimize(sweep.points.data());
      CameraShot shot;
      shot.scene = &scene;
      shot.world = &world;
      shot.conditions = ConditionsIn(world.atmosphere);
      shot.map_from_optical.linear() = map_from_optical;
      shot.map_from_optical.translation() = eye_m;
      CameraFrame frame;
      renderer.Render(shot, outputs, &frame);
      benchmark::DoNotOptimize(frame.depth_m.data());
    }
  }
  state.counters["core_at_10_hz"] =
      benchmark::Counter(0.1 * kEyes * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(BM_LidarAndDepthReadings)->Unit(benchmark::kMillisecond);

void BM_TraceInThreads(benchmark::State& state) {
  const std::vector<Ray>& rays = RaysOf(kDepth);
  const SensorScene& scene = *Sensors(true);
  std::vector<RayHit> hits(rays.size());
  for (auto _ : state) {
    // As cameras do: 15 pieces a picture.
    constexpr int kStrips = 120 * kEyes;
    const std::size_t strip = rays.size() / kStrips;
    ParallelInPieces(kStrips, 8, static_cast<int>(state.range(0)), [&](int begin, int end) {
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
