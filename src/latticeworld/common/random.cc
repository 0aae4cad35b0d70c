#include "latticeworld/common/random.h"

#include <cmath>

#include "latticeworld/common/check.h"

namespace latticeworld {
namespace {

std::uint64_t SplitMix64(std::uint64_t* state) {
  std::uint64_t z = (*state += 0x9e3779b97f4a7c15ULL);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

std::uint64_t RotateLeft(std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }

double BitsToUnit(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1.0p-53; }

}  // namespace

std::uint64_t StreamSeed(std::uint64_t seed, std::string_view stream_name) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;  // FNV-1a
  for (const char c : stream_name) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  }
  std::uint64_t state = seed ^ hash;
  return SplitMix64(&state);
}

RandomStream::RandomStream(std::uint64_t seed, std::string_view stream_name) {
  std::uint64_t state = StreamSeed(seed, stream_name);
  for (std::uint64_t& word : state_) word = SplitMix64(&state);
}

std::uint64_t RandomStream::NextBits() {
  const std::uint64_t result = RotateLeft(state_[1] * 5, 7) * 9;
  const std::uint64_t t = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= t;
  state_[3] = RotateLeft(state_[3], 45);
  return result;
}

double RandomStream::Uniform() { return BitsToUnit(NextBits()); }

double RandomStream::Uniform(double low, double high) { return low + (high - low) * Uniform(); }

int RandomStream::UniformInt(int low, int high) {
  LW_CHECK(low <= high, "an empty range has no integer to draw");
  const std::uint64_t span = static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low) + 1;
  // The bias of the modulus is below 2^-32 for every int range.
  return static_cast<int>(low + static_cast<std::int64_t>(NextBits() % span));
}

double RandomStream::Normal(double mean, double stddev) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform()));
  return mean + stddev * radius * std::cos(2.0 * M_PI * Uniform());
}

bool RandomStream::Chance(double probability) { return Uniform() < probability; }

std::size_t RandomStream::Weighted(const std::vector<double>& weights) {
  double total = 0.0;
  for (const double weight : weights) total += weight;
  LW_CHECK(total > 0.0, "at least one weight must be positive");
  double left = Uniform() * total;
  std::size_t last_positive = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] <= 0.0) continue;
    last_positive = i;
    if (left < weights[i]) return i;
    left -= weights[i];
  }
  return last_positive;
}

double HashToUnit(std::uint64_t seed, std::int64_t x, std::int64_t y) {
  std::uint64_t state = seed ^ (static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15ULL) ^
                        RotateLeft(static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fULL, 31);
  return BitsToUnit(SplitMix64(&state));
}

}  // namespace latticeworld
