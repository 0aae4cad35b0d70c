#ifndef LATTICEWORLD_COMMON_RANDOM_H_
#define LATTICEWORLD_COMMON_RANDOM_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace latticeworld {

// The seed of a stage's own stream: a hash of the world's seed and the stage's name, so that a
// change in one stage leaves the draws of the others alone.
std::uint64_t StreamSeed(std::uint64_t seed, std::string_view stream_name);

// A repeatable random stream (xoshiro256**, Blackman and Vigna 2018, seeded by SplitMix64). Its
// distributions are its own, so that draws are the same with every standard library.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::string_view stream_name);

  std::uint64_t NextBits();
  double Uniform();                           // [0, 1)
  double Uniform(double low, double high);    // [low, high)
  int UniformInt(int low, int high);          // both ends included, low <= high
  double Normal(double mean, double stddev);  // Box-Muller, no cached half
  bool Chance(double probability);
  // Index drawn with the given non-negative weights, at least one of them positive.
  std::size_t Weighted(const std::vector<double>& weights);

  template <typename T>
  void Shuffle(std::vector<T>* values) {
    for (std::size_t i = values->size(); i > 1; --i) {
      std::swap((*values)[i - 1], (*values)[UniformInt(0, static_cast<int>(i) - 1)]);
    }
  }

  // All that the next draws depend on, for hashes of a running simulation.
  std::array<std::uint64_t, 4> state() const {
    return {state_[0], state_[1], state_[2], state_[3]};
  }

 private:
  std::uint64_t state_[4];
};

// A hash of cell coordinates for noise fields: uniform in [0, 1), the same for the same arguments.
double HashToUnit(std::uint64_t seed, std::int64_t x, std::int64_t y);

}  // namespace latticeworld

#endif  // LATTICEWORLD_COMMON_RANDOM_H_
