#include <algorithm>

#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/noise.h"
#include "latticeworld/geomorphology/resample.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {
namespace {

// The land is made on this many cells a side whatever the resolution, and then interpolated.
constexpr int kLatticeCells = 128;
constexpr double kWavelengthOfSize = 0.45;

}  // namespace

Grid<float> ProceduralRelief(const GridGeometry& geometry, double amplitude_m, std::uint64_t seed) {
  NoiseOptions options;
  options.wavelength_m = kWavelengthOfSize * geometry.size_m();
  options.octaves = 3;
  options.gain = 0.35;
  Grid<float> land = FractalNoise(GridGeometry::FromCells(kLatticeCells, geometry.size_m()),
                                  options, StreamSeed(seed, "procedural_relief"));
  const auto [low, high] = std::minmax_element(land.begin(), land.end());
  const float offset = *low;
  const float scale = *high > offset ? static_cast<float>(amplitude_m) / (*high - offset) : 0.0f;
  for (float& value : land) value = (value - offset) * scale;
  return Resample(land, geometry.rows(), geometry.cols());
}

}  // namespace latticeworld
