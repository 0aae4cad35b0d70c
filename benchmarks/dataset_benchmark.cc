// How many instances of training data a second, on two threads, beside what one would do without a
// writer of data sets: ask the program for one small world after another.

#include <benchmark/benchmark.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "latticeworld/dataset/captions/written_annotator.h"
#include "latticeworld/dataset/sources/generated_source.h"
#include "latticeworld/dataset/writing/dataset_writer.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

constexpr int kThreads = 2;

class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "lw_dataset_benchmark_XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// A data set of so many places, written to the disk whole, with manifest and card.
void WriteSet(benchmark::State& state, bool environment, bool images) {
  constexpr std::size_t kPlaces = 600;
  const auto annotator = MakeWrittenAnnotator();
  GeneratedSourceOptions generated;
  generated.groups = kPlaces;
  const auto source = MakeGeneratedSource(generated).value();
  for (auto _ : state) {
    state.PauseTiming();
    const auto folder = std::make_unique<Folder>();
    state.ResumeTiming();
    DatasetJob job;
    job.source = source.get();
    job.annotator = annotator.get();
    job.out = folder->path() / "set";
    job.options.environment = environment;
    job.options.images = images;
    job.options.threads = kThreads;
    if (!WriteDataset(job, Progress(), {}).ok()) std::abort();
    state.PauseTiming();
    fs::remove_all(folder->path());
    state.ResumeTiming();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * kPlaces));
}

void BM_Layouts(benchmark::State& state) { WriteSet(state, false, false); }
void BM_LayoutsAndEnvironments(benchmark::State& state) { WriteSet(state, true, false); }
void BM_LayoutsEnvironmentsAndImages(benchmark::State& state) { WriteSet(state, true, true); }
BENCHMARK(BM_Layouts)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(BM_LayoutsAndEnvironments)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(BM_LayoutsEnvironmentsAndImages)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

// Runs the program's `command` once a place, two at a time.
void RunEach(benchmark::State& state, const std::string& command) {
  constexpr int kPlaces = 6;  // a thread
  for (auto _ : state) {
    const Folder folder;
    const auto work = [&](int thread) {
      for (int i = 0; i < kPlaces; ++i) {
        const std::string number = std::to_string(1 + thread * kPlaces + i);
        const std::string line = std::string(LATTICEWORLD_PROGRAM) + command + " --seed " + number +
                                 " --out " + (folder.path() / number).string() + " >/dev/null 2>&1";
        if (std::system(line.c_str()) != 0) std::abort();
      }
    };
    std::thread other(work, 1);
    work(0);
    other.join();
  }
  state.SetItemsProcessed(state.iterations() * kThreads * kPlaces);
}

// The smallest world there is, of two sentences.
void BM_AWorldAPlace(benchmark::State& state) {
  RunEach(state,
          " generate --layout 'A lake in the center and forest around it.' --environment"
          " 'A spring morning with rain. Three sheep graze.' --size 16");
}
void BM_AProcessAPlace(benchmark::State& state) {
  RunEach(state, " dataset --generate 1 --no-images");
}
BENCHMARK(BM_AWorldAPlace)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(BM_AProcessAPlace)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace latticeworld
