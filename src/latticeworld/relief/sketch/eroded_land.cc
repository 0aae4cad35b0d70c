#include "latticeworld/relief/sketch/eroded_land.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/common/check.h"
#include "latticeworld/common/random.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/geomorphology/erosion.h"
#include "latticeworld/geomorphology/noise.h"

namespace latticeworld {
namespace {

constexpr double kResolution_m = 16.0;
constexpr int kMinSamples = 64;
constexpr int kMaxSamples = 1024;
constexpr int kMostErosionSteps = 20;

// Drawn evenly on a scale of factors.
double UniformFactor(double low, double high, RandomStream* random) {
  return low * std::pow(high / low, random->Uniform());
}

}  // namespace

Grid<float> ErodedLand(int samples, std::uint64_t seed, int threads) {
  LW_CHECK(samples >= kMinSamples && samples <= kMaxSamples, "a piece of land has legal samples");
  RandomStream random(seed, "eroded_land");
  const int margin = samples / 4;
  const int all = samples + 2 * margin;
  const GridGeometry geometry = GridGeometry::FromCells(all, kResolution_m * all);
  const double side_m = kResolution_m * samples;

  // The land before the rivers, and where it rises.
  const double wavelength_m = side_m * UniformFactor(0.3, 1.5, &random);
  const auto amplitude_m = static_cast<float>(UniformFactor(60.0, 500.0, &random));
  NoiseOptions shape;
  shape.wavelength_m = wavelength_m;
  shape.octaves = random.UniformInt(4, 8);
  shape.gain = random.Uniform(0.35, 0.55);
  Grid<float> height = FractalNoise(geometry, shape, StreamSeed(seed, "shape"), threads);
  for (float& h : height) h *= amplitude_m;
  NoiseOptions rising;
  rising.wavelength_m = side_m * UniformFactor(0.3, 1.5, &random);
  rising.octaves = 2;
  Grid<float> uplift = FractalNoise(geometry, rising, StreamSeed(seed, "uplift"), threads);
  const auto rate_m_per_yr = static_cast<float>(UniformFactor(1e-4, 8e-4, &random));
  const auto unevenness = static_cast<float>(random.Uniform(0.5, 2.0));
  for (float& u : uplift) u = rate_m_per_yr * std::max(0.1f, 1.0f + unevenness * u);

  FluvialOptions options;
  options.steps = random.UniformInt(kMostErosionSteps / 2, kMostErosionSteps);
  options.time_step_yr = 3e4;
  options.erodibility = UniformFactor(1e-5, 4e-5, &random);
  options.area_exponent = random.Uniform(0.4, 0.5);
  options.diffusivity_m2_per_yr = random.Chance(0.5) ? UniformFactor(1e-3, 3e-2, &random) : 0.0;
  ErodeFluvially(geometry.resolution_m(), options, nullptr, &uplift, nullptr, threads, &height);

  Grid<float> middle(samples, samples);
  for (int r = 0; r < samples; ++r) {
    const float* source = height.row(r + margin) + margin;
    std::copy(source, source + samples, middle.row(r));
  }
  return middle;
}

}  // namespace latticeworld
