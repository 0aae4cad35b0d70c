#include "latticeworld/terrain/uplands.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/erosion.h"
#include "latticeworld/geomorphology/flow.h"
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

void LowerSummits(double strength, const Grid<float>& foot_m, Grid<float>* land_m) {
  constexpr double kHighShare = 0.9;  // high is what so much of the land is lower than
  std::vector<float> above_m(land_m->size());
  for (std::size_t i = 0; i < above_m.size(); ++i) {
    above_m[i] = land_m->data()[i] - foot_m.data()[i];
  }
  std::vector<float> sorted = above_m;
  const auto high = sorted.begin() + static_cast<std::ptrdiff_t>(kHighShare * sorted.size());
  std::nth_element(sorted.begin(), high, sorted.end());
  const float high_m = *high;
  if (!(high_m > 0.0f)) return;
  const auto most = static_cast<float>(strength);
  for (std::size_t i = 0; i < above_m.size(); ++i) {
    if (above_m[i] <= 0.0f) continue;
    land_m->data()[i] = foot_m.data()[i] + above_m[i] / (1.0f + most * above_m[i] / high_m);
  }
}

void Dissect(const GridGeometry& lattice, const Grid<unsigned char>& outlet, std::uint64_t seed,
             Grid<float>* land_m) {
  constexpr double kRoughness = 0.5;      // of what water finds on the slopes, in their slope
  constexpr double kAround_cells = 10.0;  // that the uplift is a mean of
  constexpr double kPace = 0.15;          // of a step: channels of 1 m^2 at slope 1 sink so far [m]
  constexpr double kCreep = 0.1;          // of a step: diffusivity * time / cell^2
  const double cell_m = lattice.resolution_m();
  const int n = lattice.rows();
  FluvialOptions options;
  options.steps = 3;
  options.area_exponent = 0.4;
  options.time_step_yr = kPace / options.erodibility;
  options.diffusivity_m2_per_yr = kCreep * cell_m * cell_m / options.time_step_yr;

  // The land rises as fast as rain takes it down now, by the same law.
  const FlowGraph flow = RouteFlow(*land_m, &outlet);
  const Grid<float> area_cells = FlowAccumulation(flow, nullptr);
  Grid<float> uplift_m_per_yr(n, n);
  for (std::size_t i = 0; i < uplift_m_per_yr.size(); ++i) {
    const std::int32_t to = flow.receiver[i];
    const auto from = static_cast<std::int32_t>(i);
    if (to == from) continue;
    const double length_m = cell_m * (to / n != from / n && to % n != from % n ? M_SQRT2 : 1.0);
    const double drop_m = std::max(land_m->data()[from] - land_m->data()[to], 0.0f);
    const double area_m2 = area_cells.data()[from] * cell_m * cell_m;
    uplift_m_per_yr.data()[i] = static_cast<float>(
        options.erodibility * std::pow(area_m2, options.area_exponent) * drop_m / length_m);
  }
  GaussianBlur(kAround_cells, &uplift_m_per_yr);
  RoughenSlopes(lattice, kRoughness, seed, land_m);
  ErodeFluvially(cell_m, options, &outlet, &uplift_m_per_yr, nullptr, 0, land_m);
}

}  // namespace latticeworld::internal
