// How fast a sketch becomes land, and how well land survives being drawn and made again. With the
// file that LATTICEWORLD_SKETCH_MODEL names, by that learned model too.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/files.h"
#include "latticeworld/geomorphology/erosion.h"
#include "latticeworld/geomorphology/noise.h"
#include "latticeworld/geomorphology/resample.h"
#include "latticeworld/relief/elevation/elevation_survey.h"
#include "latticeworld/relief/sketch/sketch.h"
#include "latticeworld/relief/sketch/sketch_model.h"

namespace latticeworld {
namespace {

// A river with four side valleys and ridges between them, (side x side): what DrawSketch would draw
// of such land, but the same at every size.
Sketch ExampleSketch(int side) {
  Sketch sketch(side, side, Stroke::kNone);
  const auto draw = [&](double x0, double y0, double x1, double y1, Stroke stroke) {
    const int steps = 2 * side;
    const int half = std::max(1, side / 256);
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      const double bend = 0.04 * std::sin(6.0 * t);
      const int row = static_cast<int>((y0 + t * (y1 - y0) + bend) * (side - 1));
      const int col = static_cast<int>((x0 + t * (x1 - x0) + bend * (y1 - y0)) * (side - 1));
      for (int r = row - half; r <= row + half; ++r) {
        for (int c = col - half; c <= col + half; ++c) {
          if (sketch.Contains({r, c})) sketch(r, c) = stroke;
        }
      }
    }
  };
  draw(0.0, 0.55, 1.0, 0.5, Stroke::kValley);
  draw(0.2, 0.1, 0.35, 0.55, Stroke::kValley);
  draw(0.55, 0.92, 0.6, 0.55, Stroke::kValley);
  draw(0.85, 0.1, 0.78, 0.52, Stroke::kValley);
  draw(0.1, 0.9, 0.22, 0.58, Stroke::kValley);
  draw(0.05, 0.1, 0.12, 0.4, Stroke::kRidge);
  draw(0.42, 0.05, 0.55, 0.4, Stroke::kRidge);
  draw(0.35, 0.95, 0.45, 0.66, Stroke::kRidge);
  draw(0.72, 0.93, 0.9, 0.64, Stroke::kRidge);
  return sketch;
}

std::string ExamplePng(int side) {
  const Sketch sketch = ExampleSketch(side);
  cv::Mat picture(side, side, CV_8UC3, cv::Scalar(255, 255, 255));
  for (int r = 0; r < side; ++r) {
    for (int c = 0; c < side; ++c) {
      if (sketch(r, c) == Stroke::kValley) picture.at<cv::Vec3b>(r, c) = {230, 60, 20};
      if (sketch(r, c) == Stroke::kRidge) picture.at<cv::Vec3b>(r, c) = {20, 20, 20};
    }
  }
  std::vector<unsigned char> bytes;
  cv::imencode(".png", picture, bytes);
  return std::string(bytes.begin(), bytes.end());
}

SketchOptions OptionsOf(const benchmark::State& state) {
  SketchOptions options;
  options.samples = static_cast<int>(state.range(0));
  options.threads = static_cast<int>(state.range(1));
  options.size_m = 2048.0;
  options.seed = 1;
  return options;
}

void CountSamples(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * state.range(0) * state.range(0));
}

// The strokes of a PNG of 1024 x 1024 and more pixels.
void BM_ReadSketch(benchmark::State& state) {
  const std::string bytes = ExamplePng(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(ReadSketch(bytes, static_cast<int>(state.range(1))));
  }
  CountSamples(state);
}

void BM_SketchToHeight(benchmark::State& state) {
  const Sketch sketch = ExampleSketch(1024);
  const SketchOptions options = OptionsOf(state);
  for (auto _ : state) {
    benchmark::DoNotOptimize(SketchToHeight(sketch, options, Progress()));
  }
  CountSamples(state);
}

// From the bytes of a picture as large as the relief.
void BM_SketchToRelief(benchmark::State& state) {
  const std::string bytes = ExamplePng(static_cast<int>(state.range(0)));
  const SketchOptions options = OptionsOf(state);
  for (auto _ : state) {
    benchmark::DoNotOptimize(SketchToRelief(bytes, options, Progress()));
  }
  CountSamples(state);
}

// Land that rivers made: the middle of a larger piece, so that its border is no coast.
Grid<float> ErodedLand(int cells, std::uint64_t seed) {
  const int margin = cells / 4;
  const int all = cells + 2 * margin;
  const GridGeometry geometry = GridGeometry::FromCells(all, 16.0 * all);
  Grid<float> height = FractalNoise(geometry, {6.0 * cells, 7, 0.5}, 2 * seed);
  Grid<float> uplift = FractalNoise(geometry, {6.0 * cells, 2, 0.5}, 2 * seed + 1);
  for (float& h : height) h *= 300.0f;
  for (float& u : uplift) u = 5e-4f * std::max(0.1f, 1.0f + 1.5f * u);
  FluvialOptions options;
  options.steps = 20;
  options.time_step_yr = 3e4;
  options.erodibility = 2e-5;
  options.area_exponent = 0.45;
  ErodeFluvially(geometry.resolution_m(), options, nullptr, &uplift, nullptr, 0, &height);
  Grid<float> middle(cells, cells);
  for (int r = 0; r < cells; ++r) {
    const float* source = height.row(r + margin) + margin;
    std::copy(source, source + cells, middle.row(r));
  }
  return middle;
}

// Ten pieces of eroded land, and the real ones of the folder that LATTICEWORLD_ELEVATION names.
std::vector<Grid<float>> Lands() {
  std::vector<Grid<float>> lands;
  for (std::uint64_t seed = 0; seed < 10; ++seed) lands.push_back(ErodedLand(256, seed));
  const char* const folder = std::getenv("LATTICEWORLD_ELEVATION");
  if (folder == nullptr) return lands;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".asc") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const std::filesystem::path& file : files) {
    const Result<std::string> bytes = ReadFile(file, std::size_t{1} << 28);
    if (!bytes.ok()) continue;
    Result<ElevationSurvey> survey = SurveyElevation(*bytes, file.filename().string());
    if (survey.ok()) lands.push_back(survey->height_m);
  }
  return lands;
}

double Correlation(const Grid<float>& a, const Grid<float>& b) {
  const auto mean = [](const Grid<float>& grid) {
    double sum = 0.0;
    for (const float value : grid) sum += value;
    return sum / static_cast<double>(grid.size());
  };
  const double mean_a = mean(a);
  const double mean_b = mean(b);
  double ab = 0.0;
  double aa = 0.0;
  double bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double da = a.data()[i] - mean_a;
    const double db = b.data()[i] - mean_b;
    ab += da * db;
    aa += da * da;
    bb += db * db;
  }
  return ab / std::sqrt(aa * bb);
}

// Of the strokes of `kind` in a, the share that lie within two cells of such a stroke in b.
double ShareNear(const Sketch& a, const Sketch& b, Stroke kind) {
  constexpr int kReach = 2;
  int all = 0;
  int near = 0;
  for (int r = 0; r < a.rows(); ++r) {
    for (int c = 0; c < a.cols(); ++c) {
      if (a(r, c) != kind) continue;
      ++all;
      bool found = false;
      for (int y = r - kReach; y <= r + kReach && !found; ++y) {
        for (int x = c - kReach; x <= c + kReach && !found; ++x) {
          found = b.Contains({y, x}) && b(y, x) == kind;
        }
      }
      near += found ? 1 : 0;
    }
  }
  return all == 0 ? 1.0 : static_cast<double>(near) / all;
}

// How well two sketches of the same land agree, [0, 1]: of both kinds and ways, the mean share of
// strokes that have a like one beside them.
double Agreement(const Sketch& a, const Sketch& b) {
  double sum = 0.0;
  for (const Stroke kind : {Stroke::kValley, Stroke::kRidge}) {
    sum += ShareNear(a, b, kind) + ShareNear(b, a, kind);
  }
  return sum / 4.0;
}

// The model that LATTICEWORLD_SKETCH_MODEL names; none, with a word in the results, without.
std::optional<SketchModel> LearnedModel(benchmark::State& state) {
  const char* const file = std::getenv("LATTICEWORLD_SKETCH_MODEL");
  if (file == nullptr) {
    state.SkipWithError("LATTICEWORLD_SKETCH_MODEL names no ONNX file");
    return std::nullopt;
  }
  Result<SketchModel> model = SketchModel::Load(file);
  if (model.ok()) return std::move(model).value();
  state.SkipWithError(model.status().ToString().c_str());
  return std::nullopt;
}

// Land, drawn, and made again from its sketch: Pearson correlation of the heights, and how well the
// sketch of what was made agrees with the sketch that it was made from. Argument: of a thousand
// cells, how many become strokes of each kind.
using MakeLand = std::function<Grid<float>(const Sketch&, const SketchOptions&)>;
void RoundTrip(benchmark::State& state, const MakeLand& make) {
  constexpr int kSamples = 256;
  const std::vector<Grid<float>> lands = Lands();
  const double share = 0.001 * static_cast<double>(state.range(0));
  double sum = 0.0;
  double worst = 1.0;
  double agreement = 0.0;
  for (auto _ : state) {
    sum = 0.0;
    agreement = 0.0;
    for (std::size_t i = 0; i < lands.size(); ++i) {
      SketchOptions options;
      options.samples = kSamples;
      options.seed = i;
      const Sketch sketch = DrawSketch(lands[i], share);
      const Grid<float> made = make(sketch, options);
      const double correlation = Correlation(Resample(lands[i], kSamples, kSamples), made);
      sum += correlation;
      worst = std::min(worst, correlation);
      agreement +=
          Agreement(sketch, DrawSketch(Resample(made, sketch.rows(), sketch.cols()), share));
      state.counters["land_" + std::to_string(i)] = correlation;
    }
  }
  state.counters["mean"] = sum / static_cast<double>(lands.size());
  state.counters["worst"] = worst;
  state.counters["agreement"] = agreement / static_cast<double>(lands.size());
}

void BM_RoundTrip(benchmark::State& state) {
  RoundTrip(state, [](const Sketch& sketch, const SketchOptions& options) {
    return SketchToHeight(sketch, options, Progress()).value();
  });
}

void BM_LearnedRoundTrip(benchmark::State& state) {
  const std::optional<SketchModel> model = LearnedModel(state);
  if (!model) return;
  RoundTrip(state, [&](const Sketch& sketch, const SketchOptions& options) {
    return SketchToHeight(sketch, *model, options, Progress()).value();
  });
}

// What the network itself gives, on which no water has worked.
void BM_ModelRoundTrip(benchmark::State& state) {
  const std::optional<SketchModel> model = LearnedModel(state);
  if (!model) return;
  RoundTrip(state, [&](const Sketch& sketch, const SketchOptions& options) {
    return Resample(model->Run(sketch).value(), options.samples, options.samples);
  });
}

// The network alone, at its own size.
void BM_LearnedModel(benchmark::State& state) {
  const std::optional<SketchModel> model = LearnedModel(state);
  if (!model) return;
  const Sketch sketch = ExampleSketch(1024);
  for (auto _ : state) benchmark::DoNotOptimize(model->Run(sketch));
  state.counters["side"] = model->side();
  state.SetItemsProcessed(state.iterations() * model->side() * model->side());
}

void Sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"samples", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
  for (const int samples : {512, 1024, 2048, 4096}) {
    for (const int threads : {0, 1}) benchmark->Args({samples, threads});
  }
}

BENCHMARK(BM_ReadSketch)->Apply(Sizes);
BENCHMARK(BM_SketchToHeight)->Apply(Sizes);
BENCHMARK(BM_SketchToRelief)->Apply(Sizes);
BENCHMARK(BM_RoundTrip)->Arg(10)->Arg(30)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_LearnedRoundTrip)->Arg(10)->Arg(30)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ModelRoundTrip)->Arg(10)->Arg(30)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_LearnedModel)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace latticeworld
