#include <benchmark/benchmark.h>

#include <cstdint>

#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/geomorphology/erosion.h"
#include "latticeworld/geomorphology/flow.h"
#include "latticeworld/geomorphology/noise.h"

namespace latticeworld {
namespace {

constexpr double kResolution_m = 1.0;

// 300 m of fractal relief.
Grid<float> RoughLand(int size) {
  const auto geometry = GridGeometry::FromCells(size, size * kResolution_m);
  Grid<float> height_m = FractalNoise(geometry, {size * kResolution_m / 3.0, 9, 0.5}, 1);
  for (float& h : height_m) h *= 300.0f;
  return height_m;
}

// Arguments: cells a side, threads (0: as many as cores). Cells a second, and the time of one;
// passes: how often one iteration goes over the grid.
void CountCells(benchmark::State& state, int passes = 1) {
  const double cells =
      passes * static_cast<double>(state.range(0)) * static_cast<double>(state.range(0));
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * cells));
  state.counters["s_per_cell"] = benchmark::Counter(
      cells, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void BM_RouteFlow(benchmark::State& state) {
  const Grid<float> land = RoughLand(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(RouteFlow(land, nullptr, static_cast<int>(state.range(1))));
  }
  CountCells(state);
}

void BM_FillDepressions(benchmark::State& state) {
  const Grid<float> land = RoughLand(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(FillDepressions(land, nullptr, static_cast<int>(state.range(1))));
  }
  CountCells(state);
}

void BM_FlowAccumulation(benchmark::State& state) {
  const Grid<float> land = RoughLand(static_cast<int>(state.range(0)));
  const FlowGraph flow = RouteFlow(land, nullptr);
  for (auto _ : state) benchmark::DoNotOptimize(FlowAccumulation(flow, nullptr));
  CountCells(state);
}

// Rough land that rises and is cut, twenty steps of 10,000 years; time is of one step.
void BM_FluvialStep(benchmark::State& state) {
  const int size = static_cast<int>(state.range(0));
  const Grid<float> land = RoughLand(size);
  const Grid<float> uplift(size, size, 1e-3f);
  FluvialOptions options;
  options.steps = 20;
  options.erodibility = 2e-5;
  for (auto _ : state) {
    Grid<float> height_m = land;
    ErodeFluvially(kResolution_m, options, nullptr, &uplift, nullptr,
                   static_cast<int>(state.range(1)), &height_m);
    benchmark::DoNotOptimize(height_m.data());
  }
  CountCells(state, options.steps);
}

// Twenty iterations; time is of one.
void BM_ThermalIteration(benchmark::State& state) {
  const Grid<float> land = RoughLand(static_cast<int>(state.range(0)));
  ThermalOptions options;
  options.iterations = 20;
  for (auto _ : state) {
    Grid<float> height_m = land;
    ErodeThermally(kResolution_m, options, nullptr, static_cast<int>(state.range(1)), &height_m);
    benchmark::DoNotOptimize(height_m.data());
  }
  CountCells(state, options.iterations);
}

void BM_Noise(benchmark::State& state) {
  const int size = static_cast<int>(state.range(0));
  const auto geometry = GridGeometry::FromCells(size, size * kResolution_m);
  for (auto _ : state) {
    benchmark::DoNotOptimize(FractalNoise(geometry, {size * kResolution_m / 3.0, 9, 0.5}, 1,
                                          static_cast<int>(state.range(1))));
  }
  CountCells(state);
}

void Sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"cells", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
  for (const int cells : {512, 1024, 2048, 4096}) {
    for (const int threads : {0, 1}) benchmark->Args({cells, threads});
  }
}

BENCHMARK(BM_RouteFlow)->Apply(Sizes);
BENCHMARK(BM_FillDepressions)->Apply(Sizes);
BENCHMARK(BM_FlowAccumulation)->Apply(Sizes);
BENCHMARK(BM_FluvialStep)->Apply(Sizes);
BENCHMARK(BM_ThermalIteration)->Apply(Sizes);
BENCHMARK(BM_Noise)->Apply(Sizes);

}  // namespace
}  // namespace latticeworld
