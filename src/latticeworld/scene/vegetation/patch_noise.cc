#include "latticeworld/scene/vegetation/patch_noise.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/scene/point_random.h"

namespace latticeworld {
namespace {

double ValueAt(std::uint64_t seed, std::int64_t x, std::int64_t y) {
  const std::uint64_t key = seed + 0x9e3779b97f4a7c15ULL * static_cast<std::uint64_t>(x) +
                            0xc2b2ae3d27d4eb4fULL * static_cast<std::uint64_t>(y);
  return static_cast<double>(MixBits(key) >> 11) * 0x1.0p-53;
}

double Octave(std::uint64_t seed, double x, double y) {
  const double x0 = std::floor(x), y0 = std::floor(y);
  const auto ix = static_cast<std::int64_t>(x0), iy = static_cast<std::int64_t>(y0);
  const double u = x - x0, v = y - y0;
  const double su = u * u * (3.0 - 2.0 * u), sv = v * v * (3.0 - 2.0 * v);
  const double south = ValueAt(seed, ix, iy) * (1.0 - su) + ValueAt(seed, ix + 1, iy) * su;
  const double north = ValueAt(seed, ix, iy + 1) * (1.0 - su) + ValueAt(seed, ix + 1, iy + 1) * su;
  return south * (1.0 - sv) + north * sv;
}

}  // namespace

PatchNoise::PatchNoise(std::uint64_t seed, double wavelength_m)
    : seed_(MixBits(seed)), per_m_(2.0 / wavelength_m) {}

double PatchNoise::At(WorldPoint point) const {
  // Turned against each other, so that no direction of the lattices shows.
  constexpr double kCosine = 0.8, kSine = 0.6, kFiner = 2.17;
  const double x = point.x_m * per_m_, y = point.y_m * per_m_;
  const double coarse = Octave(seed_, x, y);
  const double fine = Octave(~seed_, kFiner * (kCosine * x - kSine * y) + 0.37,
                             kFiner * (kSine * x + kCosine * y) + 0.71);
  // Interpolation draws the values together: spread them out again.
  constexpr double kSpread = 1.9;
  return std::clamp(0.5 + kSpread * (0.68 * coarse + 0.32 * fine - 0.5), 0.0, 1.0);
}

}  // namespace latticeworld
