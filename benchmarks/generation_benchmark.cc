// How long a world takes from words, whole and by stage.

#include <benchmark/benchmark.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <string>

#include "example_world.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/generation/world_generator.h"

namespace latticeworld {
namespace {

// Worlds of one request, a seed each: the whole, its stages, and all but who reads and answers the
// words (`without_reading_ms`).
void Generate(GenerationRequest request, benchmark::State* state) {
  WorldGenerator generator = MakeDefaultWorldGenerator();
  std::map<std::string, double> stages;
  double reading_s = 0.0;
  const auto start = std::chrono::steady_clock::now();
  for (auto _ : *state) {
    ++request.seed;
    const auto world = generator.Generate(request, Progress()).value();
    for (const StageTime& stage : world->stages) {
      stages[stage.name] += stage.seconds;
      const bool reads = stage.name == "layout" || stage.name == "environment";
      reading_s += reads ? stage.seconds : 0.0;
    }
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  const auto worlds = static_cast<double>(state->iterations());
  for (const auto& [name, seconds] : stages) {
    state->counters[name + "_ms"] = 1e3 * seconds / worlds;
  }
  state->counters["without_reading_ms"] = 1e3 * (elapsed.count() - reading_s) / worlds;
  const double cells =
      (request.size_m / request.resolution_m) * (request.size_m / request.resolution_m);
  state->SetItemsProcessed(static_cast<std::int64_t>(cells) * state->iterations());
}

void BM_GenerateWorld(benchmark::State& state) {
  GenerationRequest request = ExampleRequest();
  request.size_m = static_cast<double>(state.range(0));
  Generate(request, &state);
}
BENCHMARK(BM_GenerateWorld)
    ->Arg(128)
    ->Arg(256)
    ->Arg(512)
    ->Arg(1024)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

// 1024 x 1024 cells, all of them mountain; and hills with ways and bridges of their own.
void BM_Relief(benchmark::State& state) {
  constexpr const char* kTexts[] = {
      "Snow mountain.",
      "A steep hill with a path of 15 degrees to its top and a bridge over the gorge."};
  GenerationRequest request = ExampleRequest();
  request.layout_instruction = kTexts[state.range(0)];
  request.environment_instruction.clear();
  state.SetLabel(request.layout_instruction);
  Generate(request, &state);
}
BENCHMARK(BM_Relief)
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

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
BENCHMARK(BM_SaveBundle)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace latticeworld
