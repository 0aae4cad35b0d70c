#include "latticeworld/language/local/llama_math.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/language/local/lane_math.h"

namespace latticeworld {
namespace {

// Powers of e: 2 to a whole number, made from the bits of a float, times a
// polynomial of the rest in [-ln 2 / 2, ln 2 / 2] (Taylor's, whose seventh
// power is below 2e-7 there).
LATTICEWORLD_LANE_INLINE void ExpOfLanes(FloatLanes* lanes) {
  FloatLanes x = *lanes;
  constexpr float kLeast = -87.0f, kMost = 88.0f;
  const Int32Lanes vanishes = x < kLeast;
  const FloatLanes least = FloatLanes{} + kLeast, most = FloatLanes{} + kMost;
  x = x < kLeast ? least : x;
  x = x > kMost ? most : x;
  constexpr float kLog2E = 1.44269504f, kLn2High = 0.693359375f, kLn2Low = -2.12194440e-4f;
  constexpr float kRounder = 12582912.0f;  // 1.5 * 2^23: adding it rounds to whole numbers
  const FloatLanes whole = (x * kLog2E + kRounder) - kRounder;
  const FloatLanes rest = (x - whole * kLn2High) - whole * kLn2Low;
  FloatLanes sum = rest * (1.0f / 720.0f) + (1.0f / 120.0f);
  sum = sum * rest + (1.0f / 24.0f);
  sum = sum * rest + (1.0f / 6.0f);
  sum = sum * rest + 0.5f;
  sum = sum * rest + 1.0f;
  sum = sum * rest + 1.0f;
  const Int32Lanes bits = (__builtin_convertvector(whole, Int32Lanes) + 127) << 23;
  FloatLanes power;
  std::memcpy(&power, &bits, sizeof(power));
  const FloatLanes zero = {};
  *lanes = vanishes ? zero : sum * power;
}

LATTICEWORLD_LANE_INLINE void ExpInPlace(float* values, std::size_t size) {
  for (std::size_t i = 0; i < size; i += kLanes) {
    const std::size_t some = std::min(kLanes, size - i);
    FloatLanes lanes = {};
    std::memcpy(&lanes, values + i, some * sizeof(float));
    ExpOfLanes(&lanes);
    std::memcpy(values + i, &lanes, some * sizeof(float));
  }
}

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

LATTICEWORLD_LANE_CLONES
void GateWithSwish(float* gates, const float* ups, std::size_t size) {
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

LATTICEWORLD_LANE_CLONES
void AttendHead(const float* query, const float* keys, const float* values, std::size_t stride,
                std::size_t width, std::size_t length, float* scores, float* out) {
  std::size_t place = 0;
  for (; place + 4 <= length; place += 4)
    DotProducts<4>(query, keys + place * stride, stride, width, scores + place);
  for (; place < length; ++place)
    DotProducts<1>(query, keys + place * stride, stride, width, scores + place);
  const float highest = *std::max_element(scores, scores + length);
  const float scale = 1.0f / std::sqrt(static_cast<float>(width));
  for (std::size_t i = 0; i < length; ++i) scores[i] = (scores[i] - highest) * scale;
  ExpInPlace(scores, length);
  std::fill_n(out, width, 0.0f);
  double sum = 0.0;
  for (std::size_t i = 0; i < length; ++i) {
    sum += scores[i];
    const float share = scores[i];
    const float* value = values + i * stride;
    for (std::size_t k = 0; k < width; ++k) out[k] += share * value[k];
  }
  const auto inverse = static_cast<float>(1.0 / sum);
  for (std::size_t k = 0; k < width; ++k) out[k] *= inverse;
}

LATTICEWORLD_LANE_CLONES
void Exponentials(float* values, std::size_t size) { ExpInPlace(values, size); }

}  // namespace latticeworld
