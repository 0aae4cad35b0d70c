#include "latticeworld/terrain/uplands.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/noise.h"
#include "latticeworld/geomorphology/slope.h"

namespace latticeworld::internal {

void RoughenSlopes(const GridGeometry& lattice, double share, std::uint64_t seed,
                   Grid<float>* land_m) {
  constexpr double kAround_cells = 3.0;
  NoiseOptions options;
  options.wavelength_m = 16.0 * lattice.resolution_m();
  options.octaves = 3;
  options.gain = 0.57;
  const Grid<float> noise = FractalNoise(lattice, options, seed);
  Grid<float> slope = GradientMagnitude(*land_m, lattice.resolution_m());
  GaussianBlur(kAround_cells, &slope);
  const auto amplitude_m = static_cast<float>(share * options.wavelength_m);
  for (std::size_t i = 0; i < slope.size(); ++i) {
    land_m->data()[i] += amplitude_m * slope.data()[i] * noise.data()[i];
  }
}

void LowerSummits(double strength, Grid<float>* land_m) {
  // The foot of the range: a few low cells, such as a gorge's, are not what it is measured from.
  constexpr std::size_t kFootShare = 100;
  constexpr float kOnset = 1.5f;  // the larger, the less is lowered that is not high
  std::vector<float> heights(land_m->begin(), land_m->end());
  const auto foot = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / kFootShare);
  std::nth_element(heights.begin(), foot, heights.end());
  const float low_m = *foot;
  const float range_m = *std::max_element(foot, heights.end()) - low_m;
  if (!(range_m > 0.0f)) return;
  const auto most = static_cast<float>(strength);
  for (float& height_m : *land_m) {
    const float above_m = height_m - low_m;
    if (above_m <= 0.0f) continue;
    height_m = low_m + above_m / (1.0f + most * std::pow(above_m / range_m, kOnset));
  }
}

}  // namespace latticeworld::internal
