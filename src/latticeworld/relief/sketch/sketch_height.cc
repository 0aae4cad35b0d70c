#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/common/parallel.h"
#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/erosion.h"
#include "latticeworld/geomorphology/noise.h"
#include "latticeworld/geomorphology/resample.h"
#include "latticeworld/geomorphology/slope.h"
#include "latticeworld/relief/sketch/sketch.h"
#include "latticeworld/relief/sketch/sketch_erosion.h"
#include "latticeworld/relief/sketch/sketch_lines.h"
#include "latticeworld/relief/sketch/sketch_model.h"
#include "latticeworld/relief/sketch/sketch_surface.h"

namespace latticeworld {
namespace {

constexpr char kStage[] = "relief";
constexpr int kSurfaceCells = 512;  // a side, at most, of the grid on which strokes become land

// Roughness that is too fine for water to have made it: from this many cells of the eroded grid
// down to a metre, below which soil creep leaves nothing, as high as this share of its wavelength
// times the slope of the ground.
constexpr double kDetailCells = 8.0;
constexpr double kFinestDetail_m = 1.0;
constexpr double kDetailGain = 0.5;
constexpr float kDetail = 0.04f;
constexpr double kSlopeBlur = 1.5;  // [cells] of the eroded grid

// Slopes steeper than this [heights a side] slide.
constexpr int kSlideIterations = 96;
constexpr double kTalus = 6.0;
// At most this many iterations on 1024 x 1024 samples run between two checks for a cancel.
constexpr int kIterationsAtATime = 8;

void AddDetail(const Grid<float>& eroded, const SketchOptions& options, Grid<float>* height) {
  const double wavelength = kDetailCells / eroded.cols();  // [sides]
  const double octaves = std::floor(std::log2(wavelength * options.size_m / kFinestDetail_m)) + 1.0;
  if (octaves < 1.0) return;
  NoiseOptions noise_options;
  noise_options.wavelength_m = wavelength * options.size_m;
  noise_options.octaves = static_cast<int>(std::min(octaves, 16.0));
  noise_options.gain = kDetailGain;
  const int samples = height->cols();
  const Grid<float> noise =
      FractalNoise(GridGeometry::FromCells(samples, options.size_m), noise_options,
                   StreamSeed(options.seed, "detail"), options.threads);
  Grid<float> slope = GradientMagnitude(eroded, 1.0 / eroded.cols(), options.threads);
  GaussianBlur(kSlopeBlur, &slope, options.threads);
  slope = Resample(slope, samples, samples, options.threads);
  const float share = kDetail * static_cast<float>(wavelength);
  ParallelFor(samples, options.threads, [&](int begin, int end) {
    for (int r = begin; r < end; ++r) {
      float* target = height->row(r);
      const float* steep = slope.row(r);
      const float* rough = noise.row(r);
      for (int c = 0; c < samples; ++c) target[c] += share * steep[c] * rough[c];
    }
  });
}

// Errors: CANCELLED.
Status Slide(int threads, const Progress& progress, Grid<float>* height) {
  const double share = 1024.0 / height->cols();
  ThermalOptions options;
  options.talus = kTalus;
  for (int done = 0; done < kSlideIterations; done += options.iterations) {
    progress.Report(kStage, 0.6 + 0.4 * done / kSlideIterations);
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    options.iterations = std::clamp(static_cast<int>(kIterationsAtATime * share * share), 1,
                                    kSlideIterations - done);
    ErodeThermally(1.0 / height->cols(), options, nullptr, threads, height);
  }
  return Status();
}

// What water makes of the strokes' land. land: as MakeSketchSurface takes it.
Result<Grid<float>> RaiseLand(const Sketch& sketch, const Grid<float>* land,
                              const SketchOptions& options, const Progress& progress) {
  LW_CHECK(std::any_of(sketch.begin(), sketch.end(), [](Stroke s) { return s != Stroke::kNone; }),
           "a sketch has strokes");
  const std::uint64_t seed = StreamSeed(options.seed, "sketch");
  LW_ASSIGN_OR_RETURN(
      const internal::SketchSurface surface,
      internal::MakeSketchSurface(sketch, land, std::min(options.samples, kSurfaceCells), seed,
                                  options.threads, progress));
  progress.Report(kStage, 0.3);
  LW_ASSIGN_OR_RETURN(
      const Grid<float> eroded,
      internal::ErodeSurface(surface, options.samples, seed, options.threads, progress));
  Grid<float> height = Resample(eroded, options.samples, options.samples, options.threads);
  AddDetail(eroded, options, &height);
  LW_RETURN_IF_ERROR(Slide(options.threads, progress, &height));
  internal::StretchHeights(options, &height);
  progress.Report(kStage, 1.0);
  return height;
}

}  // namespace

Result<Grid<float>> SketchToHeight(const Sketch& sketch, const SketchOptions& options,
                                   const Progress& progress) {
  LW_RETURN_IF_ERROR(Status::FromViolations("illegal sketch options", Validate(options)));
  return RaiseLand(sketch, nullptr, options, progress);
}

Result<Grid<float>> SketchToHeight(const Sketch& sketch, const SketchModel& model,
                                   const SketchOptions& options, const Progress& progress) {
  LW_RETURN_IF_ERROR(Status::FromViolations("illegal sketch options", Validate(options)));
  LW_ASSIGN_OR_RETURN(const Grid<float> land, model.Run(sketch));
  const auto [low, high] = std::minmax_element(land.begin(), land.end());
  if (!(*high > *low))
    return Internal("the sketch model gives level land: the same height everywhere");
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  return RaiseLand(sketch, &land, options, progress);
}

}  // namespace latticeworld
