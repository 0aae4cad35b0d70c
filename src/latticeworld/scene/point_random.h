#ifndef LATTICEWORLD_SCENE_POINT_RANDOM_H_
#define LATTICEWORLD_SCENE_POINT_RANDOM_H_

#include <cmath>
#include <cstdint>

namespace latticeworld {

// The finalizer of SplitMix64 (Steele, Lea and Flood 2014): every bit depends on every other.
inline std::uint64_t MixBits(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

// A short random stream that belongs to a place (a cell, a tile, a field), so that places can be
// worked on in any order and by any number of threads. RandomStream, which is better over long
// runs, gives the seed of the stage.
class PointRandom {
 public:
  PointRandom(std::uint64_t seed, std::uint64_t place)
      : state_(MixBits(seed + MixBits(place + kGolden))) {}

  std::uint64_t NextBits() { return MixBits(state_ += kGolden); }
  double Uniform() { return static_cast<double>(NextBits() >> 11) * 0x1.0p-53; }  // [0, 1)
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }
  bool Chance(double probability) { return Uniform() < probability; }
  // Box-Muller.
  double Normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform()));
    return radius * std::cos(2.0 * M_PI * Uniform());
  }

 private:
  static constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15ULL;
  std::uint64_t state_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_POINT_RANDOM_H_
