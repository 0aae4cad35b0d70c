#include "latticeworld/language/grounded/smooth_field.h"

#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {
namespace {

double Fade(double t) { return t * t * (3.0 - 2.0 * t); }

double ValueNoise(std::uint64_t seed, double x, double y) {
  const auto x0 = static_cast<std::int64_t>(std::floor(x));
  const auto y0 = static_cast<std::int64_t>(std::floor(y));
  const double u = Fade(x - static_cast<double>(x0));
  const double v = Fade(y - static_cast<double>(y0));
  const double top = HashToUnit(seed, x0, y0) * (1 - u) + HashToUnit(seed, x0 + 1, y0) * u;
  const double low = HashToUnit(seed, x0, y0 + 1) * (1 - u) + HashToUnit(seed, x0 + 1, y0 + 1) * u;
  return top * (1 - v) + low * v;
}

}  // namespace

Grid<float> SmoothField(std::uint64_t seed, double wavelength) {
  const std::uint64_t fine_seed = StreamSeed(seed, "fine octave");
  Grid<float> field(kLayoutSize, kLayoutSize);
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      const double coarse = ValueNoise(seed, col / wavelength, row / wavelength);
      const double fine = ValueNoise(fine_seed, 2.3 * col / wavelength, 2.3 * row / wavelength);
      field(row, col) = static_cast<float>((2.0 * coarse + fine) / 3.0);
    }
  }
  return field;
}

}  // namespace latticeworld
