#include "latticeworld/geomorphology/realism_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace latticeworld {
namespace {

constexpr std::size_t kMinPoints = 4;
constexpr double kDeviationOfNormal = 1.4826;  // standard over median absolute deviation

// values: not empty; reordered.
double Median(std::vector<double>* values) {
  const std::size_t middle = values->size() / 2;
  std::nth_element(values->begin(), values->begin() + middle, values->end());
  const double upper = (*values)[middle];
  if (values->size() % 2 == 1) return upper;
  return 0.5 * (upper + *std::max_element(values->begin(), values->begin() + middle));
}

}  // namespace

RealismEstimate FitSlope(const std::vector<double>& x, const std::vector<double>& y) {
  RealismEstimate fit;
  if (x.size() < kMinPoints) return fit;
  std::vector<double> slopes;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (x[i] != x[j]) slopes.push_back((y[i] - y[j]) / (x[i] - x[j]));
    }
  }
  if (slopes.empty()) return fit;
  fit.value = Median(&slopes);

  std::vector<double> residuals(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) residuals[i] = y[i] - fit.value * x[i];
  std::vector<double> sorted = residuals;
  const double intercept = Median(&sorted);
  for (double& residual : residuals) residual = std::abs(residual - intercept);
  double mean_x = 0.0;
  for (const double value : x) mean_x += value / x.size();
  double spread = 0.0;
  for (const double value : x) spread += (value - mean_x) * (value - mean_x);
  fit.standard_error = kDeviationOfNormal * Median(&residuals) / std::sqrt(spread);
  return fit;
}

void HalfOctaves::Add(double key, double value, double weight) {
  if (!(key >= low_)) return;
  const auto index = static_cast<std::size_t>(2.0 * std::log2(key / low_));
  if (index >= bins_.size()) bins_.resize(index + 1);
  Bin& bin = bins_[index];
  ++bin.count;
  bin.log_key += weight * std::log(key);
  bin.value += value;
  bin.weight += weight;
}

}  // namespace latticeworld
