#include "latticeworld/geomorphology/realism_relief.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "latticeworld/geomorphology/slope.h"

namespace latticeworld {
namespace {

constexpr std::array<double, 5> kSlopeQuantiles = {0.05, 0.25, 0.5, 0.75, 0.95};

// The values of the dry cells.
std::vector<float> DryValues(const Grid<float>& values, const Grid<unsigned char>& dry) {
  std::vector<float> kept;
  kept.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (dry.data()[i] != 0) kept.push_back(values.data()[i]);
  }
  return kept;
}

}  // namespace

void MeasureSlopes(const Grid<float>& height_m, double resolution_m, const Grid<unsigned char>& dry,
                   RealismMeasures* measures) {
  std::vector<float> gradients = DryValues(GradientMagnitude(height_m, resolution_m), dry);
  double sum_rad = 0.0;
  for (const float gradient : gradients) sum_rad += std::atan(gradient);
  measures->mean_slope_rad = sum_rad / gradients.size();
  for (std::size_t q = 0; q < kSlopeQuantiles.size(); ++q) {
    const auto rank = gradients.begin() + std::lround(kSlopeQuantiles[q] * (gradients.size() - 1));
    std::nth_element(gradients.begin(), rank, gradients.end());
    measures->slope_quantiles_rad[q] = std::atan(*rank);
  }
}

void MeasureHypsometry(const Grid<float>& height_m, const Grid<unsigned char>& dry,
                       RealismMeasures* measures) {
  const std::vector<float> heights = DryValues(height_m, dry);
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  const double low_m = *low;
  measures->relief_m = *high - low_m;
  if (!(measures->relief_m > 0.0)) {
    measures->hypsometric_curve.fill(std::numeric_limits<double>::quiet_NaN());
    measures->hypsometric_integral = std::numeric_limits<double>::quiet_NaN();
    return;
  }
  // at_least[k]: cells whose relative height is at least k / 10.
  std::array<std::size_t, 11> at_least{};
  double sum = 0.0;
  for (const float height : heights) {
    const double relative = (height - low_m) / measures->relief_m;
    sum += relative;
    ++at_least[std::min<std::size_t>(static_cast<std::size_t>(10.0 * relative), 10)];
  }
  for (std::size_t k = 10; k-- > 0;) at_least[k] += at_least[k + 1];
  for (std::size_t k = 0; k < at_least.size(); ++k) {
    measures->hypsometric_curve[k] = static_cast<double>(at_least[k]) / heights.size();
  }
  measures->hypsometric_integral = sum / heights.size();
}

}  // namespace latticeworld
