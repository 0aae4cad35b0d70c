#include "latticeworld/relief/caption.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/geometry/region.h"

namespace latticeworld::internal {
namespace {

constexpr int kNinths = 9;
constexpr double kFlat_m = 0.5;          // less relief than this is called flat
constexpr double kSpreadOfMeans = 0.15;  // of the relief: below it no ninth stands out
constexpr double kHighShare = 0.7;       // of the range of the means: high ground
constexpr double kLowShare = 0.3;        // low ground
constexpr std::size_t kMostPlacesNamed = 3;

std::array<double, kNinths> MeansOfNinths(const Grid<float>& height_m) {
  std::array<double, kNinths> sum{};
  std::array<double, kNinths> count{};
  for (int r = 0; r < height_m.rows(); ++r) {
    for (int c = 0; c < height_m.cols(); ++c) {
      const int ninth = 3 * (3 * r / height_m.rows()) + 3 * c / height_m.cols();
      sum[ninth] += height_m(r, c);
      count[ninth] += 1.0;
    }
  }
  for (int i = 0; i < kNinths; ++i) sum[i] /= count[i];
  return sum;
}

std::string Places(const std::vector<int>& ninths) {
  std::string text;
  const std::size_t named = std::min(ninths.size(), kMostPlacesNamed);
  for (std::size_t i = 0; i < named; ++i) {
    if (i > 0) text += i + 1 == named ? " and " : ", ";
    const auto place = static_cast<Region>(ninths[i]);
    text += "the ";
    text += NameOf(place);
    if (place == Region::kUpper || place == Region::kLower) text += " middle";
  }
  return text;
}

// "84 m"; small reliefs with one decimal.
std::string Metres(double value_m) {
  const double rounded =
      std::abs(value_m) < 10.0 ? std::round(value_m * 10.0) / 10.0 : std::round(value_m);
  return FormatDouble(rounded + 0.0) + " m";  // + 0.0: no "-0"
}

}  // namespace

std::string CaptionOf(const Grid<float>& height_m) {
  const auto [low, high] = std::minmax_element(height_m.begin(), height_m.end());
  const double relief_m = static_cast<double>(*high) - *low;
  const std::string numbers =
      "relief " + Metres(relief_m) + ", heights from " + Metres(*low) + " to " + Metres(*high);
  if (relief_m < kFlat_m) return "nearly flat land; " + numbers;

  const std::array<double, kNinths> means = MeansOfNinths(height_m);
  std::array<int, kNinths> order;
  for (int i = 0; i < kNinths; ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return means[a] > means[b]; });
  const double highest = means[order.front()];
  const double lowest = means[order.back()];
  if (highest - lowest < kSpreadOfMeans * relief_m) {
    return "hills and hollows all over, no part much higher than another; " + numbers;
  }
  std::vector<int> high_ninths;
  std::vector<int> low_ninths;
  for (int i = 0; i < kNinths; ++i) {
    if (means[order[i]] >= lowest + kHighShare * (highest - lowest)) {
      high_ninths.push_back(order[i]);
    }
    const int from_below = order[kNinths - 1 - i];
    if (means[from_below] <= lowest + kLowShare * (highest - lowest)) {
      low_ninths.push_back(from_below);
    }
  }
  return "high ground in " + Places(high_ninths) + " falling to low ground in " +
         Places(low_ninths) + "; " + numbers;
}

}  // namespace latticeworld::internal
