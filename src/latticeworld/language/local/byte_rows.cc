#include "latticeworld/language/local/byte_rows.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/language/local/gguf_file.h"

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#define LATTICEWORLD_HAS_AVX2_ROWS
#endif

namespace latticeworld {
namespace {

constexpr std::size_t kBlock = kQ8BlockValues;
constexpr std::size_t kByteLanes = 8, kLaneBytes = kBlock / kByteLanes;

// The nearest float16, ties to even, of what is not negative; what is too large stays as it is.
float RoundedToHalf(float value) {
  if (value >= 65520.0f) return value;
  // Adding and taking away a number whose last bit is that of the float16 rounds to it.
  int exponent = 0;
  std::frexp(value, &exponent);
  const float step = std::ldexp(1.5f, std::max(exponent - 11, -24) + 23);
  return (value + step) - step;
}

float SumOfEight(const float* lanes) {
  return ((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) +
         ((lanes[1] + lanes[5]) + (lanes[3] + lanes[7]));
}

// The dot products of one row of weights with every row of activations.
void RowPlainly(const std::int8_t* weights, const float* scales, const ByteRows& in,
                std::size_t stride, float* out) {
  const std::size_t blocks = in.columns / kBlock;
  for (std::size_t t = 0; t < in.count; ++t) {
    float lanes[kByteLanes] = {};
    for (std::size_t block = 0; block < blocks; ++block) {
      const std::int8_t* a = weights + block * kBlock;
      const std::int8_t* b = in.bytes.data() + t * in.columns + block * kBlock;
      const float scale = scales[block] * in.scales[t * blocks + block];
      for (std::size_t lane = 0; lane < kByteLanes; ++lane) {
        std::int32_t sum = 0;
        for (std::size_t i = lane * kLaneBytes; i < (lane + 1) * kLaneBytes; ++i)
          sum += std::int32_t{a[i]} * b[i];
        lanes[lane] += static_cast<float>(sum) * scale;
      }
    }
    out[t * stride] = SumOfEight(lanes);
  }
}

#ifdef LATTICEWORLD_HAS_AVX2_ROWS
// The same with 32 products at a time: magnitudes of weights times activations with the weights'
// signs, whose pairs fit into an int16.
__attribute__((target("avx2"))) void RowByAvx2(const std::int8_t* weights, const float* scales,
                                               const ByteRows& in, std::size_t stride, float* out) {
  const std::size_t blocks = in.columns / kBlock;
  const __m256i ones = _mm256_set1_epi16(1);
  for (std::size_t t = 0; t < in.count; ++t) {
    __m256 lanes = _mm256_setzero_ps();
    const std::int8_t* row = in.bytes.data() + t * in.columns;
    const float* row_scales = in.scales.data() + t * blocks;
    for (std::size_t block = 0; block < blocks; ++block) {
      const __m256i a =
          _mm256_loadu_si256(reinterpret_cast<const __m256i*>(weights + block * kBlock));
      const __m256i b = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(row + block * kBlock));
      const __m256i pairs = _mm256_maddubs_epi16(_mm256_abs_epi8(a), _mm256_sign_epi8(b, a));
      const __m256 sums = _mm256_cvtepi32_ps(_mm256_madd_epi16(pairs, ones));
      const __m256 scale = _mm256_set1_ps(scales[block] * row_scales[block]);
      lanes = _mm256_add_ps(lanes, _mm256_mul_ps(sums, scale));
    }
    alignas(32) float stored[kByteLanes];
    _mm256_store_ps(stored, lanes);
    out[t * stride] = SumOfEight(stored);
  }
}
#endif

using RowFunction = decltype(&RowPlainly);

RowFunction FastestRow() {
#ifdef LATTICEWORLD_HAS_AVX2_ROWS
  if (__builtin_cpu_supports("avx2")) return &RowByAvx2;
#endif
  return &RowPlainly;
}

}  // namespace

ByteRows RoundToBytes(const float* in, std::size_t count, std::size_t columns) {
  ByteRows rows;
  rows.count = count;
  rows.columns = columns;
  rows.bytes.resize(count * columns);
  rows.scales.resize(count * columns / kBlock);
  constexpr float kRounder = 12582912.0f;  // 1.5 * 2^23: adding it rounds to whole numbers
  for (std::size_t block = 0; block < rows.scales.size(); ++block) {
    const float* values = in + block * kBlock;
    std::int8_t* bytes = rows.bytes.data() + block * kBlock;
    float most = 0.0f;
    for (std::size_t i = 0; i < kBlock; ++i) most = std::max(most, std::abs(values[i]));
    // What is no number makes an answer of noise; it is not to be undefined.
    if (!std::isfinite(most)) most = 0.0f;
    rows.scales[block] = RoundedToHalf(most / 127.0f);
    const float inverse = most > 0.0f ? 127.0f / most : 0.0f;
    for (std::size_t i = 0; i < kBlock; ++i) {
      const float scaled = std::isfinite(values[i]) ? values[i] * inverse : 0.0f;
      bytes[i] = static_cast<std::int8_t>((scaled + kRounder) - kRounder);
    }
  }
  return rows;
}

void MultiplyBytes(const ByteWeights& weights, const ByteRows& in, float* out) {
  static const RowFunction row = FastestRow();
  const std::size_t blocks = in.columns / kBlock;
  for (std::size_t r = 0; r < weights.rows; ++r)
    row(weights.bytes + r * in.columns, weights.scales + r * blocks, in, weights.rows, out + r);
}

}  // namespace latticeworld
