// Ray scenes and pictures of a kilometre of wood with 100,000 trees.

#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/rendering/picture.h"
#include "latticeworld/rendering/views/close_view.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/sensing/solids/ray_scene.h"
#include "wood.h"

namespace latticeworld {
namespace {

const Scene& Wood() { return *KilometreOfWood(); }

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
