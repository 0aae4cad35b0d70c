// How long a world takes from words, whole and by stage.

#include <benchmark/benchmark.h>

#include <filesystem>

#include "example_world.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/generation/world_generator.h"

namespace latticeworld {
namespace {

void BM_GenerateWorld(benchmark::State& state) {
  WorldGenerator generator = MakeDefaultWorldGenerator();
  GenerationRequest request = ExampleRequest();
  request.size_m = static_cast<double>(state.range(0));
  std::map<std::string, double> stages;
  for (auto _ : state) {
    ++request.seed;
    const auto world = generator.Generate(request, Progress()).value();
    for (const StageTime& stage : world->stages) stages[stage.name] += stage.seconds;
  }
  for (const auto& [name, seconds] : stages) {
    state.counters[name + "_ms"] = 1e3 * seconds / static_cast<double>(state.iterations());
  }
  const double cells =
      (request.size_m / request.resolution_m) * (request.size_m / request.resolution_m);
  state.SetItemsProcessed(static_cast<std::int64_t>(cells) * state.iterations());
}
BENCHMARK(BM_GenerateWorld)->Arg(128)->Arg(256)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond);

void BM_SaveBundle(benchmark::State& state) {
  const auto world = ExampleWorld();
  const std::filesystem::path directory =
      std::filesystem::temp_directory_path() / "latticeworld_benchmark_bundle";
  std::filesystem::remove_all(directory);
  for (auto _ : state) {
    const Status status = SaveBundle(*world, directory);
    if (!status.ok()) return state.SkipWithError(status.ToString().c_str());
    state.PauseTiming();
    std::filesystem::remove_all(directory);
    state.ResumeTiming();
  }
}
BENCHMARK(BM_SaveBundle)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace latticeworld
