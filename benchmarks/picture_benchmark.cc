// Ray scenes and pictures of a kilometre of wood with 100,000 trees.

#include <benchmark/benchmark.h>

#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/exporting/close_view.h"
#include "latticeworld/exporting/picture.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/sensing/ray_scene.h"

namespace latticeworld {
namespace {

const Scene& Wood() {
  static const Scene scene = [] {
    constexpr int kCells = 2000, kTrees = 100000;
    const GridGeometry geometry = GridGeometry::FromCells(kCells, 1000.0);
    Grid<float> height_m(kCells, kCells);
    for (int row = 0; row < kCells; ++row) {
      for (int col = 0; col < kCells; ++col) {
        const WorldPoint p = geometry.CenterOf({row, col});
        height_m(row, col) =
            static_cast<float>(20.0 * std::sin(p.x_m / 130.0 + 0.4) * std::cos(p.y_m / 170.0));
      }
    }
    auto terrain = std::make_shared<Terrain>();
    terrain->ground = HeightField(geometry, std::move(height_m));
    terrain->water_level_m = Grid<float>(kCells, kCells, std::numeric_limits<float>::quiet_NaN());
    terrain->surface = Grid<SurfaceClass>(kCells, kCells, SurfaceClass::kForestFloor);
    Scene wood;
    wood.terrain = terrain;
    const auto& models = wood.catalogue->models_of(AssetKind::kTree);
    RandomStream random(1, "wood");
    for (int i = 0; i < kTrees; ++i) {
      Asset tree;
      tree.model = models[static_cast<std::size_t>(i) % models.size()];
      tree.x_m = static_cast<float>(random.Uniform(-499.0, 499.0));
      tree.y_m = static_cast<float>(random.Uniform(-499.0, 499.0));
      tree.z_m = static_cast<float>(terrain->ground.HeightAt(tree.position()));
      tree.yaw_rad = static_cast<float>(random.Uniform(0.0, 6.28));
      tree.height_m = static_cast<float>(random.Uniform(8.0, 22.0));
      tree.half_length_m = tree.half_width_m = 0.2f * tree.height_m;
      tree.trunk_radius_m = 0.15f;
      wood.assets.push_back(tree);
    }
    wood.index = AssetIndex(geometry.size_m(), wood.assets);
    return wood;
  }();
  return scene;
}

void BM_MakeRayScene(benchmark::State& state) {
  RaySceneOptions options;
  options.eye_m = Eigen::Vector3d(0.0, 0.0, 20.0);
  for (auto _ : state) {
    auto rays = RayScene::Create(Wood(), options, Progress());
    benchmark::DoNotOptimize(rays);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(Wood().assets.size()));
}
BENCHMARK(BM_MakeRayScene)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_TraceRays(benchmark::State& state) {
  const RayScene rays = RayScene::Create(Wood(), RaySceneOptions(), Progress()).value();
  RandomStream random(2, "rays");
  std::vector<Ray> shots(100000);
  for (Ray& ray : shots) {
    ray.origin_m = {0.0f, 0.0f, 25.0f};
    ray.direction = Eigen::Vector3f(static_cast<float>(random.Normal(0.0, 1.0)),
                                    static_cast<float>(random.Normal(0.0, 1.0)),
                                    static_cast<float>(random.Normal(-0.2, 0.2)))
                        .normalized();
  }
  for (auto _ : state)
    for (const Ray& ray : shots) benchmark::DoNotOptimize(rays.Trace(ray, kSeesAll));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(shots.size()));
}
BENCHMARK(BM_TraceRays)->Unit(benchmark::kMillisecond)->UseRealTime();

// quick: as the previews of bundles are drawn.
void BM_ObliqueView(benchmark::State& state) {
  PictureOptions options;
  options.width_px = static_cast<int>(state.range(0));
  options.quick = state.range(1) != 0;
  for (auto _ : state) benchmark::DoNotOptimize(DrawObliqueView(Wood(), options));
}
BENCHMARK(BM_ObliqueView)
    ->Args({512, 1})
    ->Args({1200, 0})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void BM_CloseView(benchmark::State& state) {
  CloseView view;
  view.eye_height_m = 25.0;
  for (auto _ : state) benchmark::DoNotOptimize(DrawCloseView(Wood(), view, PictureOptions()));
}
BENCHMARK(BM_CloseView)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace latticeworld
