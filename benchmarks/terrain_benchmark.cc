// What a terrain costs per sample, by its number of samples, without a relief and with one. The
// cost of a sample must not grow with their number.

#include <benchmark/benchmark.h>

#include <cmath>
#include <utility>

#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/relief/relief.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld {
namespace {

// A river valley with a lake, fields, woods, a village and a road over the river.
SymbolicLayout Valley() {
  SymbolicLayout layout{Vocabulary::kSuburb, Grid<char>(kLayoutSize, kLayoutSize, 'G')};
  for (int r = 0; r < kLayoutSize; ++r) {
    const int river = 15 + static_cast<int>(std::lround(5.0 * std::sin(r / 5.0)));
    for (int c = 0; c < kLayoutSize; ++c) {
      char& cell = layout.cells(r, c);
      if (c > 21) cell = 'F';
      if (r > 20 && c < 12) cell = 'A';
      if (std::hypot(r - 8, c - 5) < 3.5) cell = 'B';
      if (std::hypot(r - 26, c - 24) < 4.5) cell = 'D';
      if (c == river || c == river + 1 || std::hypot(r - 29, c - 15) < 3.0) cell = 'W';
      if (r == 11) cell = 'R';
    }
  }
  return layout;
}

// Mountains of rock and snow around a wooded valley with a lake.
SymbolicLayout Mountains() {
  SymbolicLayout layout{Vocabulary::kWild, Grid<char>(kLayoutSize, kLayoutSize, 'B')};
  for (int r = 0; r < kLayoutSize; ++r) {
    for (int c = 0; c < kLayoutSize; ++c) {
      char& cell = layout.cells(r, c);
      if (std::abs(c - 16) > 4) cell = 'F';
      if (std::abs(c - 16) > 7) cell = 'R';
      if (std::abs(c - 16) > 11) cell = 'S';
      if (c == 16 || std::hypot(r - 20, c - 16) < 3.0) cell = 'W';
    }
  }
  return layout;
}

Relief Hills() {
  Grid<float> height_m(1025, 1025);
  for (int r = 0; r < height_m.rows(); ++r) {
    for (int c = 0; c < height_m.cols(); ++c) {
      height_m(r, c) = static_cast<float>(40.0 + 25.0 * std::sin(r / 130.0) * std::cos(c / 170.0));
    }
  }
  return MakeRelief(std::move(height_m));
}

void Build(const SymbolicLayout& layout, const Relief* relief, benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  TerrainRequest request;
  request.geometry = GridGeometry::FromCells(cells, 0.5 * cells);
  request.layout = &layout;
  request.relief = relief;
  for (auto _ : state) {
    ++request.seed;
    benchmark::DoNotOptimize(BuildTerrain(request, Progress()).value());
  }
  const double samples = static_cast<double>(cells) * cells;
  state.SetItemsProcessed(static_cast<std::int64_t>(samples) * state.iterations());
  // Time a sample.
  state.counters["s_per_sample"] =
      benchmark::Counter(samples * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void BM_Valley(benchmark::State& state) { Build(Valley(), nullptr, state); }
void BM_Mountains(benchmark::State& state) { Build(Mountains(), nullptr, state); }
void BM_ValleyOnRelief(benchmark::State& state) {
  const Relief relief = Hills();
  Build(Valley(), &relief, state);
}

BENCHMARK(BM_Valley)->RangeMultiplier(2)->Range(512, 4096)->UseRealTime()->Unit(
    benchmark::kMillisecond);
BENCHMARK(BM_Mountains)
    ->RangeMultiplier(2)
    ->Range(512, 4096)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ValleyOnRelief)
    ->RangeMultiplier(2)
    ->Range(512, 4096)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace latticeworld
