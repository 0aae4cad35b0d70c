#ifndef LATTICEWORLD_RENDERING_RAY_RAY_NOISE_H_
#define LATTICEWORLD_RENDERING_RAY_RAY_NOISE_H_

#include <Eigen/Core>
#include <cstdint>

namespace latticeworld {

// Draws for pictures, from where something is rather than from a stream, so that pixels may be
// drawn in any order.

// A hash of three numbers (the finaliser of MurmurHash3, Appleby 2011, over their mixture).
inline std::uint32_t HashOf(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  std::uint32_t h =
      a * 0x9e3779b1u ^ (b + 0x7f4a7c15u) * 0x85ebca6bu ^ (c + 0x165667b1u) * 0xc2b2ae35u;
  h ^= h >> 16;
  h *= 0x85ebca6bu;
  h ^= h >> 13;
  h *= 0xc2b2ae35u;
  h ^= h >> 16;
  return h;
}
// Uniform in [0, 1).
inline float UnitHash(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return static_cast<float>(HashOf(a, b, c) >> 8) * (1.0f / 16777216.0f);
}

// Value noise with bumps one wide, in [-1, 1], smooth.
float ValueNoise(float x, float y, std::uint32_t seed);
// Octaves of it from wavelength_m down, each of half the wavelength and `gain` the height of the
// one before; those that a footprint of footprint_m cannot show fade out. About [-1, 1].
float DetailNoise(float x_m, float y_m, float wavelength_m, int octaves, float gain,
                  float footprint_m, std::uint32_t seed);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_RAY_RAY_NOISE_H_
