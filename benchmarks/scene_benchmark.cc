// Placement of a forest of one square kilometre, and plain dart throwing beside it.

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/vegetation/blue_noise.h"

namespace {

// Bytes on the heap, now and at most.
std::atomic<long> g_live{0}, g_peak{0};

void Count(void* pointer, long sign) {
  const long live = g_live += sign * static_cast<long>(malloc_usable_size(pointer));
  long peak = g_peak;
  while (live > peak && !g_peak.compare_exchange_weak(peak, live)) {
  }
}

}  // namespace

void* operator new(std::size_t size) {
  void* pointer = std::malloc(size);
  if (pointer == nullptr) throw std::bad_alloc();
  Count(pointer, 1);
  return pointer;
}
void operator delete(void* pointer) noexcept {
  if (pointer == nullptr) return;
  Count(pointer, -1);
  std::free(pointer);
}
void operator delete(void* pointer, std::size_t) noexcept { operator delete(pointer); }

namespace latticeworld {
namespace {

constexpr double kSize_m = 1000.0;
constexpr int kCells = 1000;

// Rolling forest floor, one class.
std::shared_ptr<const Terrain> ForestGround() {
  static const std::shared_ptr<const Terrain> terrain = [] {
    const GridGeometry geometry = GridGeometry::FromCells(kCells, kSize_m);
    auto ground = std::make_shared<Terrain>();
    Grid<float> height_m(kCells, kCells);
    for (int row = 0; row < kCells; ++row) {
      for (int col = 0; col < kCells; ++col) {
        const WorldPoint point = geometry.CenterOf({row, col});
        height_m(row, col) = static_cast<float>(
            30.0 + 12.0 * std::sin(0.013 * point.x_m) * std::cos(0.017 * point.y_m) +
            3.0 * std::sin(0.06 * point.x_m + 0.05 * point.y_m));
      }
    }
    ground->ground = HeightField(geometry, std::move(height_m));
    ground->water_level_m = Grid<float>(kCells, kCells, NAN);
    ground->surface = Grid<SurfaceClass>(kCells, kCells, SurfaceClass::kForestFloor);
    ground->weights.vocabulary = Vocabulary::kWild;
    ground->weights.classes.push_back({'F', Grid<float>(kCells, kCells, 1.0f)});
    return ground;
  }();
  return terrain;
}

// Trees only, or all that stands in a forest; as many trees as asked for.
SceneRequest ForestRequest(int trees, bool only_trees) {
  SceneRequest request;
  request.terrain = ForestGround();
  request.catalogue =
      Catalogue::Extended(
          {{"benchmark.json", R"({"type": "forest", "density": [{"kind": "tree", "wild": {"F": )" +
                                  std::to_string(trees / 100) + "}}]}"}})
          .value();
  request.environment.coarse.terrain_type = TerrainType::kForest;
  request.environment.fine = DeriveFineAttributes(request.environment.coarse);
  for (FineAttribute& fine : request.environment.fine) fine.density = only_trees ? 0.0 : 0.5;
  request.environment.fine_of(AssetType::kForest).density = 1.0;
  request.seed = 1;
  return request;
}

void PlaceForest(benchmark::State& state, bool only_trees) {
  const SceneRequest request = ForestRequest(static_cast<int>(state.range(0)), only_trees);
  const Progress progress;
  double assets = 0.0, held = 0.0, peak = 0.0, trees = 0.0;
  for (auto _ : state) {
    const long before = g_live;
    g_peak = before;
    const SceneAnswer answer = BuildScene(request, progress).value();
    held = static_cast<double>(g_live - before);
    peak = static_cast<double>(g_peak - before);
    assets = static_cast<double>(answer.scene->assets.size());
    trees = answer.counts[static_cast<std::size_t>(AssetKind::kTree)].placed;
  }
  state.counters["trees"] = trees;
  state.counters["assets"] = assets;
  state.counters["bytes_per_asset"] = held / assets;
  state.counters["peak_bytes_per_asset"] = peak / assets;
  state.counters["assets_per_second"] =
      benchmark::Counter(assets, benchmark::Counter::kIsIterationInvariantRate);
}

void BM_PlaceTrees(benchmark::State& state) { PlaceForest(state, true); }
BENCHMARK(BM_PlaceTrees)
    ->Arg(25000)
    ->Arg(50000)
    ->Arg(100000)
    ->Arg(200000)
    ->Arg(400000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void BM_PlaceForest(benchmark::State& state) { PlaceForest(state, false); }
BENCHMARK(BM_PlaceForest)
    ->Arg(25000)
    ->Arg(50000)
    ->Arg(100000)
    ->Arg(200000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

// The points alone.
void BM_BlueNoise(benchmark::State& state) {
  const double per_m2 = static_cast<double>(state.range(0)) / (kSize_m * kSize_m);
  std::size_t points = 0;
  for (auto _ : state) {
    const RankedBlueNoise noise(
        kSize_m, per_m2, 1, [](WorldPoint, WorldPoint) { return 1.0; }, 0);
    std::vector<WorldPoint> all;
    for (int tile = 0; tile < noise.tiles(); ++tile) {
      noise.ForEachIn(tile, [&](const RankedBlueNoise::Point& point) {
        all.push_back({point.x_m, point.y_m});
      });
    }
    points = all.size();
  }
  state.counters["points"] = static_cast<double>(points);
  state.counters["spacing_m"] = BlueNoiseSpacing(per_m2);
}
BENCHMARK(BM_BlueNoise)
    ->Arg(5000)
    ->Arg(25000)
    ->Arg(50000)
    ->Arg(100000)
    ->Arg(200000)
    ->Arg(400000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

// As it is written first: throw a dart, keep it unless it is too near to one that is kept, until
// there are as many. The same count and the same least distance as BM_BlueNoise; with a hash grid,
// or looking through the whole list.
template <bool kGrid>
void ThrowDarts(benchmark::State& state) {
  const auto wanted = static_cast<std::size_t>(state.range(0));
  const double spacing_m = BlueNoiseSpacing(static_cast<double>(wanted) / (kSize_m * kSize_m));
  const int side = kGrid ? static_cast<int>(kSize_m / spacing_m) : 1;
  double darts = 0.0;
  for (auto _ : state) {
    RandomStream random(1, "darts");
    std::vector<std::vector<WorldPoint>> buckets(static_cast<std::size_t>(side) * side);
    std::size_t count = 0;
    for (darts = 0.0; count < wanted; darts += 1.0) {
      const WorldPoint dart = {random.Uniform(0.0, kSize_m), random.Uniform(0.0, kSize_m)};
      const int x = static_cast<int>(dart.x_m / kSize_m * side);
      const int y = static_cast<int>(dart.y_m / kSize_m * side);
      bool is_free = true;
      for (int by = std::max(0, y - 1); by <= std::min(side - 1, y + 1) && is_free; ++by) {
        for (int bx = std::max(0, x - 1); bx <= std::min(side - 1, x + 1) && is_free; ++bx) {
          for (const WorldPoint& other : buckets[by * side + bx]) {
            if (std::hypot(other.x_m - dart.x_m, other.y_m - dart.y_m) < spacing_m) {
              is_free = false;
              break;
            }
          }
        }
      }
      if (!is_free) continue;
      buckets[y * side + x].push_back(dart);
      ++count;
    }
    benchmark::DoNotOptimize(buckets);
  }
  state.counters["points"] = static_cast<double>(wanted);
  state.counters["darts_per_point"] = darts / static_cast<double>(wanted);
}

void BM_DartsInGrid(benchmark::State& state) { ThrowDarts<true>(state); }
BENCHMARK(BM_DartsInGrid)
    ->Arg(5000)
    ->Arg(25000)
    ->Arg(50000)
    ->Arg(100000)
    ->Arg(200000)
    ->Arg(400000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Iterations(1);

void BM_DartsInList(benchmark::State& state) { ThrowDarts<false>(state); }
BENCHMARK(BM_DartsInList)
    ->Arg(2500)
    ->Arg(5000)
    ->Arg(10000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Iterations(1);

}  // namespace
}  // namespace latticeworld
