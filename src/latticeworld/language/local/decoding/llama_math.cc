#include "latticeworld/language/local/decoding/llama_math.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/language/local/decoding/lane_math.h"

namespace latticeworld {
namespace {

LATTICEWORLD_LANE_INLINE void ExpInPlace(float* values, std::size_t size) {
  for (std::size_t i = 0; i < size; i += kLanes) {
    const std::size_t some = std::min(kLanes, size - i);
    FloatLanes lanes = {};
    std::memcpy(&lanes, values + i, some * sizeof(float));
    ExpOfLanes(&lanes);
    std::memcpy(values + i, &lanes, some * sizeof(float));
  }
}

struct SwishGate {
  LATTICEWORLD_LANE_INLINE static void Run(float* gates, const float* ups, std::size_t size) {
    constexpr std::size_t kPiece = 256;
    float powers[kPiece];
    for (std::size_t begin = 0; begin < size; begin += kPiece) {
      const std::size_t some = std::min(kPiece, size - begin);
      for (std::size_t i = 0; i < some; ++i) powers[i] = -gates[begin + i];
      ExpInPlace(powers, some);
      for (std::size_t i = 0; i < some; ++i)
        gates[begin + i] = gates[begin + i] / (1.0f + powers[i]) * ups[begin + i];
    }
  }
};

struct Powers {
  LATTICEWORLD_LANE_INLINE static void Run(float* values, std::size_t size) {
    ExpInPlace(values, size);
  }
};

}  // namespace

void RootMeanSquareNorm(const float* in, const float* gains, std::size_t count, std::size_t width,
                        float epsilon, float* out) {
  for (std::size_t row = 0; row < count; ++row, in += width, out += width) {
    double squares = 0.0;
    for (std::size_t i = 0; i < width; ++i) squares += double{in[i]} * in[i];
    const float scale =
        1.0f / std::sqrt(static_cast<float>(squares / static_cast<double>(width)) + epsilon);
    for (std::size_t i = 0; i < width; ++i) out[i] = in[i] * scale * gains[i];
  }
}

void GateWithSwish(float* gates, const float* ups, std::size_t size) {
  WithLanes<SwishGate>(gates, ups, size);
}

void Exponentials(float* values, std::size_t size) { WithLanes<Powers>(values, size); }

}  // namespace latticeworld
