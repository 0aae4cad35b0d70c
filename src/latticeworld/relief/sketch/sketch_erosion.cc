#include "latticeworld/relief/sketch/sketch_erosion.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/geomorphology/erosion.h"
#include "latticeworld/geomorphology/noise.h"
#include "latticeworld/geomorphology/resample.h"
#include "latticeworld/relief/sketch/sketch_lines.h"

namespace latticeworld::internal {
namespace {

// One grid of the pyramid. Time is in units in which water that drains the whole unit square cuts
// its way back at one side a unit.
struct Stage {
  int cells;
  int steps;
  double time;
  double roughness_wavelength;  // [sides]
  float roughness;              // [heights]
  double creep_cells;           // how far soil creeps in a step, which rounds slopes
};
constexpr Stage kStages[] = {
    {256, 6, 1.5, 0.16, 0.2f, 1.0},
    {512, 4, 0.6, 0.04, 0.06f, 1.0},
    {1024, 2, 0.2, 0.01, 0.02f, 0.8},
};
constexpr double kAreaExponent = 0.45;  // the concavity index of nature's channels
// While the broad valleys form, the land rises by this share of its height.
constexpr float kUplift = 0.1f;
// Roughness fades towards drawn valleys over this length [sides]: their banks stay low.
constexpr float kSmoothBank = 0.04f;

void AddRoughness(const Stage& stage, int cells, const Grid<float>& freedom, std::uint64_t seed,
                  int threads, Grid<float>* height) {
  NoiseOptions options;
  options.wavelength_m = stage.roughness_wavelength;
  options.octaves = 4;
  options.gain = 0.55;
  const Grid<float> noise =
      FractalNoise(GridGeometry::FromCells(cells, 1.0), options, seed, threads);
  for (std::size_t i = 0; i < height->size(); ++i) {
    height->data()[i] += stage.roughness * freedom.data()[i] * noise.data()[i];
  }
}

// Returns a field that is 0 along drawn valleys and rises to 1 away from them.
Grid<float> FreedomOf(const SketchSurface& surface, int threads) {
  Grid<unsigned char> drawn = surface.courses.valley;
  for (unsigned char& kind : drawn) kind = kind == kDrawn;
  Grid<float> freedom = DistanceTo(true, drawn, threads);
  const float scale = 1.0f / (kSmoothBank * static_cast<float>(freedom.cols()));
  for (float& value : freedom) value = std::min(1.0f, value * scale);
  return freedom;
}

}  // namespace

Result<Grid<float>> ErodeSurface(const SketchSurface& surface, int samples, std::uint64_t seed,
                                 int threads, const Progress& progress) {
  const Grid<unsigned char> outlet = FindOutlets(surface, threads);
  const Grid<float> freedom = FreedomOf(surface, threads);
  FluvialOptions fluvial;
  fluvial.steps = 1;
  fluvial.erodibility = 1.0;
  fluvial.area_exponent = kAreaExponent;
  Grid<float> height;
  Grid<float> change;  // what the stages before have made of the surface
  for (const Stage& stage : kStages) {
    const bool first = height.empty();
    if (!first && stage.cells > samples) break;
    const int cells = std::min(stage.cells, samples);
    const Grid<float> before = Resample(surface.height, cells, cells, threads);
    height = before;
    if (!first) {
      change = Resample(change, cells, cells, threads);
      for (std::size_t i = 0; i < height.size(); ++i) height.data()[i] += change.data()[i];
    }
    AddRoughness(stage, cells, Resample(freedom, cells, cells, threads),
                 StreamSeed(seed, "roughness " + std::to_string(stage.cells)), threads, &height);

    const Grid<unsigned char> stage_outlet = ResampleMask(outlet, cells, cells);
    Grid<float> uplift;
    if (first) {
      uplift = height;
      for (float& value : uplift) value = kUplift * std::max(0.0f, value);
    }
    fluvial.time_step_yr = stage.time / stage.steps;
    for (int step = 0; step < stage.steps; ++step) {
      LW_RETURN_IF_ERROR(progress.CheckCancelled());
      if (step > 0) GaussianBlur(stage.creep_cells, &height, threads);
      ErodeFluvially(1.0 / cells, fluvial, &stage_outlet, first ? &uplift : nullptr, nullptr,
                     threads, &height);
    }
    change = height;
    for (std::size_t i = 0; i < change.size(); ++i) change.data()[i] -= before.data()[i];
  }
  return height;
}

}  // namespace latticeworld::internal
