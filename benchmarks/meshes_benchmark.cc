// How fast meshes are built: single models at a detail, and everything that a world may need.
#include <benchmark/benchmark.h>

#include <string_view>

#include "latticeworld/meshes/mesh.h"

namespace latticeworld {
namespace {

const AssetModel& ModelNamed(std::string_view name) {
  const auto& models = Catalogue::BuiltIn()->models();
  for (const AssetModel& model : models) {
    if (model.name == name) return model;
  }
  return models.front();
}

void BuildModel(benchmark::State& state, const char* name) {
  const AssetModel& model = ModelNamed(name);
  const auto detail = static_cast<int>(state.range(0));
  const double foliage = static_cast<double>(state.range(1)) / 100.0;
  std::size_t triangles = 0;
  int variation = 0;
  for (auto _ : state) {
    const Mesh mesh = BuildMesh(model, foliage, detail, variation++ % kMeshVariations);
    triangles += mesh.triangles.size();
    benchmark::DoNotOptimize(mesh.vertices.data());
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(triangles));
}
BENCHMARK_CAPTURE(BuildModel, oak, "oak")
    ->ArgNames({"detail", "foliage_percent"})
    ->Args({0, 100})
    ->Args({0, 0})
    ->Args({1, 100})
    ->Args({2, 100})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BuildModel, spruce, "spruce")
    ->ArgNames({"detail", "foliage_percent"})
    ->Args({0, 100})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BuildModel, farmhouse, "farmhouse")
    ->ArgNames({"detail", "foliage_percent"})
    ->Args({0, 100})
    ->Unit(benchmark::kMicrosecond);

// Every built-in model in every variation at every detail.
void BuildAll(benchmark::State& state) {
  std::size_t triangles = 0;
  for (auto _ : state) {
    for (const AssetModel& model : Catalogue::BuiltIn()->models()) {
      for (int detail = 0; detail < kMeshDetails; ++detail) {
        for (int variation = 0; variation < kMeshVariations; ++variation) {
          triangles += BuildMesh(model, 1.0, detail, variation).triangles.size();
        }
      }
    }
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(triangles));
}
BENCHMARK(BuildAll)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace latticeworld
