#include "latticeworld/rendering/ray/ray_noise.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {

float ValueNoise(float x, float y, std::uint32_t seed) {
  const float x_low = std::floor(x), y_low = std::floor(y);
  const auto i = static_cast<std::uint32_t>(static_cast<std::int32_t>(x_low));
  const auto j = static_cast<std::uint32_t>(static_cast<std::int32_t>(y_low));
  float u = x - x_low, v = y - y_low;
  u = u * u * (3.0f - 2.0f * u);
  v = v * v * (3.0f - 2.0f * v);
  const float south = UnitHash(i, j, seed) * (1.0f - u) + UnitHash(i + 1, j, seed) * u;
  const float north = UnitHash(i, j + 1, seed) * (1.0f - u) + UnitHash(i + 1, j + 1, seed) * u;
  return 2.0f * (south * (1.0f - v) + north * v) - 1.0f;
}

float DetailNoise(float x_m, float y_m, float wavelength_m, int octaves, float gain,
                  float footprint_m, std::uint32_t seed) {
  float sum = 0.0f, height = 1.0f;
  for (int octave = 0; octave < octaves; ++octave) {
    const float shown = std::clamp(2.0f - 2.0f * footprint_m / (0.5f * wavelength_m), 0.0f, 1.0f);
    if (shown <= 0.0f) break;
    // Turned, so that the octaves' lattices do not lie on each other.
    const float u = 0.8f * x_m - 0.6f * y_m, v = 0.6f * x_m + 0.8f * y_m;
    sum += shown * height * ValueNoise(u / wavelength_m, v / wavelength_m, seed + octave);
    height *= gain;
    wavelength_m *= 0.5f;
    x_m = u;
    y_m = v;
  }
  return sum;
}

}  // namespace latticeworld
