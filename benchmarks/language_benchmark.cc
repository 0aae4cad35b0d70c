// How long the grounded back end takes from words to a layout and an environment, over the
// instructions of the fidelity benchmark's development part.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

#include "latticeworld/generation/fidelity/fidelity_benchmark.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/language/reading/instruction_reader.h"
#include "process_time.h"

namespace latticeworld {
namespace {

const FidelityBenchmark& Instructions() {
  static const FidelityBenchmark benchmark =
      ReadFidelityBenchmark(LATTICEWORLD_FIDELITY_BENCHMARK, BenchmarkPart::kDevelopment).value();
  return benchmark;
}

double Quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

// Each iteration answers one layout instruction and one environment instruction for that layout.
void BM_LayoutAndEnvironment(benchmark::State& state) {
  const FidelityBenchmark& instructions = Instructions();
  const auto layouts = MakeGroundedLayoutGenerator();
  const auto environments = MakeGroundedEnvironmentGenerator();
  std::vector<double> together_ms;
  std::size_t next = 0;
  for (auto _ : state) {
    const double begin_s = ProcessCpuSeconds();
    LayoutRequest layout_request;
    const LayoutItem& item = instructions.layouts[next % instructions.layouts.size()];
    layout_request.instruction = item.instruction;
    layout_request.vocabulary = item.vocabulary;
    layout_request.seed = next + 1;
    const auto layout = layouts->Generate(layout_request, Progress());
    EnvironmentRequest environment_request;
    environment_request.instruction =
        instructions.environments[next % instructions.environments.size()].instruction;
    environment_request.layout = &layout->layout;
    environment_request.seed = next + 1;
    benchmark::DoNotOptimize(environments->Generate(environment_request, Progress()));
    together_ms.push_back(1e3 * (ProcessCpuSeconds() - begin_s));
    ++next;
  }
  state.counters["median_ms"] = Quantile(together_ms, 0.5);
  state.counters["p90_ms"] = Quantile(together_ms, 0.9);
  state.counters["longest_ms"] = Quantile(together_ms, 1.0);
}
BENCHMARK(BM_LayoutAndEnvironment)->Iterations(480)->Unit(benchmark::kMillisecond);

// The reading alone, without a layout. The first one loads the word lists.
void BM_ReadLayoutInstruction(benchmark::State& state) {
  const LayoutItem& first = Instructions().layouts.front();
  benchmark::DoNotOptimize(ReadLayoutInstruction(first.instruction, first.vocabulary));
  std::size_t next = 0;
  for (auto _ : state) {
    const LayoutItem& item = Instructions().layouts[next++ % Instructions().layouts.size()];
    benchmark::DoNotOptimize(ReadLayoutInstruction(item.instruction, item.vocabulary));
  }
}
BENCHMARK(BM_ReadLayoutInstruction)->Unit(benchmark::kMicrosecond);

// The reader `controlled`: ten sentences of the small language, with what the report says of them.
void BM_ReadSmallLanguage(benchmark::State& state) {
  LayoutRequest request;
  request.instruction =
      "A large lake in the north-west. 2 villages in the eastern half. Forest surrounds the lake. "
      "A winding river from the lake to the southern edge. A road connects the villages. The road "
      "crosses the river. Farmland covers 20 % of the map. More forest than farmland. No rock. The "
      "rest is grassland.";
  const auto reader = MakeControlledReader();
  for (auto _ : state) {
    std::vector<ModelReply> replies;
    benchmark::DoNotOptimize(reader->ReadLayout(request, Progress(), &replies));
  }
}
BENCHMARK(BM_ReadSmallLanguage)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace latticeworld
