#include "latticeworld/sensing/counter_noise.h"

#include <array>
#include <cmath>
#include <string>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

constexpr int kQuantiles = 4096;
constexpr double kCut = 4.0;

double NormalDistribution(double x) { return 0.5 * std::erfc(-x * M_SQRT1_2); }

// Returns where the standard normal distribution function is p, (0, 1), by bisection.
double NormalQuantile(double p) {
  double low = -kCut, high = kCut;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (NormalDistribution(middle) < p ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

std::array<float, kQuantiles + 1> MakeQuantiles() {
  std::array<double, kQuantiles + 1> quantiles{};
  quantiles[0] = -kCut;
  quantiles[kQuantiles] = kCut;
  // The upper half mirrors the lower one, so that the mean is 0 exactly.
  for (int i = 1; i < kQuantiles / 2; ++i) {
    quantiles[i] = NormalQuantile(static_cast<double>(i) / kQuantiles);
    quantiles[kQuantiles - i] = -quantiles[i];
  }
  double variance = 0.0;
  for (int i = 0; i < kQuantiles; ++i) {
    const double a = quantiles[i], b = quantiles[i + 1];
    variance += (a * a + a * b + b * b) / (3.0 * kQuantiles);
  }
  std::array<float, kQuantiles + 1> scaled{};
  for (int i = 0; i <= kQuantiles; ++i) {
    scaled[i] = static_cast<float>(quantiles[i] / std::sqrt(variance));
  }
  return scaled;
}

const std::array<float, kQuantiles + 1> kNormalQuantiles = MakeQuantiles();

}  // namespace

std::uint64_t NoiseKey(std::uint64_t seed, std::string_view robot, std::string_view sensor,
                       std::string_view what) {
  std::string stream = "sensing/";
  stream.append(robot).append("/").append(sensor).append("/").append(what);
  return StreamSeed(seed, stream);
}

float NormalOf(std::uint64_t bits) {
  const auto cell = static_cast<std::size_t>((bits >> 12) & (kQuantiles - 1));
  const float share = static_cast<float>(bits & 0xfff) * (1.0f / 4096.0f);
  return kNormalQuantiles[cell] + share * (kNormalQuantiles[cell + 1] - kNormalQuantiles[cell]);
}

}  // namespace latticeworld
