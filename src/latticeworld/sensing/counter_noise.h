#ifndef LATTICEWORLD_SENSING_COUNTER_NOISE_H_
#define LATTICEWORLD_SENSING_COUNTER_NOISE_H_

#include <Eigen/Core>
#include <cstdint>
#include <string_view>

namespace latticeworld {

// Random numbers that are functions of a key and a counter (Salmon et al. 2011), so that millions
// of them come in any order, on any thread, or not at all, and each stays the same. The mixing is
// SplitMix64's (Steele, Lea and Flood 2014).

// Returns the key of the random numbers of one sensor's stream. seed: of the rig; what: "imu",
// "lidar" ...
std::uint64_t NoiseKey(std::uint64_t seed, std::string_view robot, std::string_view sensor,
                       std::string_view what);

inline std::uint64_t CounterBits(std::uint64_t key, std::uint64_t counter) {
  std::uint64_t z = key + (counter + 1) * 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

// The key of the n-th reading of a stream.
inline std::uint64_t KeyOf(std::uint64_t key, std::uint64_t n) { return CounterBits(~key, n); }

// [0, 1) of the lower 24 bits.
inline float UnitOf(std::uint64_t bits) {
  return static_cast<float>(bits & 0xffffff) * (1.0f / 16777216.0f);
}

// Standard normal of the lower 24 bits: the inverse distribution function, even between 4096
// quantiles, cut at 4 standard deviations and scaled to the variance 1.
float NormalOf(std::uint64_t bits);

// The same of a key and a counter.
inline double NormalAt(std::uint64_t key, std::uint64_t counter) {
  return NormalOf(CounterBits(key, counter));
}

// Three of them, one an axis, of the n-th reading.
inline Eigen::Vector3d NormalsAt(std::uint64_t key, std::uint64_t n) {
  return {NormalAt(key, 3 * n), NormalAt(key, 3 * n + 1), NormalAt(key, 3 * n + 2)};
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_COUNTER_NOISE_H_
