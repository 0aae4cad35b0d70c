#include "latticeworld/language/local/weights/byte_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "latticeworld/language/local/weights/gguf_file.h"

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#define LATTICEWORLD_HAS_VECTOR_ROWS
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

// Sums of the products of four bytes each: those of blocks 0, 2, 4 ... in the first eight lanes,
// those of 1, 3, 5 ... in the others. All ways below add in this order.
float SumOfLanes(const float* lanes) {
  float eight[kByteLanes];
  for (std::size_t i = 0; i < kByteLanes; ++i) eight[i] = lanes[i] + lanes[i + kByteLanes];
  return ((eight[0] + eight[4]) + (eight[2] + eight[6])) +
         ((eight[1] + eight[5]) + (eight[3] + eight[7]));
}

// The dot products of one row of weights with every row of activations.
void RowPlainly(const std::int8_t* weights, const float* scales, const ByteRows& in,
                std::size_t stride, float* out) {
  const std::size_t blocks = in.columns / kBlock;
  for (std::size_t t = 0; t < in.count; ++t) {
    float lanes[2 * kByteLanes] = {};
    for (std::size_t block = 0; block < blocks; ++block) {
      const std::int8_t* a = weights + block * kBlock;
      const std::int8_t* b = in.bytes.data() + t * in.columns + block * kBlock;
      const float scale = scales[block] * in.scales[t * blocks + block];
      float* of_block = lanes + block % 2 * kByteLanes;
      for (std::size_t lane = 0; lane < kByteLanes; ++lane) {
        std::int32_t sum = 0;
        for (std::size_t i = lane * kLaneBytes; i < (lane + 1) * kLaneBytes; ++i)
          sum += std::int32_t{a[i]} * b[i];
        of_block[lane] += static_cast<float>(sum) * scale;
      }
    }
    out[t * stride] = SumOfLanes(lanes);
  }
}

#ifdef LATTICEWORLD_HAS_VECTOR_ROWS
// The same with 32 products at a time: magnitudes of weights times activations with the weights'
// signs, whose pairs fit into an int16.
__attribute__((target("avx2"))) inline __m256 ProductsByAvx2(const std::int8_t* weights,
                                                             const std::int8_t* row, float scale) {
  const __m256i a = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(weights));
  const __m256i b = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(row));
  const __m256i pairs = _mm256_maddubs_epi16(_mm256_abs_epi8(a), _mm256_sign_epi8(b, a));
  const __m256i sums = _mm256_madd_epi16(pairs, _mm256_set1_epi16(1));
  return _mm256_mul_ps(_mm256_cvtepi32_ps(sums), _mm256_set1_ps(scale));
}

// Sums as SumOfLanes does.
__attribute__((target("avx2"))) inline float SumByAvx2(__m256 even, __m256 odd) {
  const __m256 eight = _mm256_add_ps(even, odd);
  const __m128 four = _mm_add_ps(_mm256_castps256_ps128(eight), _mm256_extractf128_ps(eight, 1));
  const __m128 two = _mm_add_ps(four, _mm_movehl_ps(four, four));
  return _mm_cvtss_f32(_mm_add_ss(two, _mm_movehdup_ps(two)));
}

__attribute__((target("avx2"))) void RowByAvx2(const std::int8_t* weights, const float* scales,
                                               const ByteRows& in, std::size_t stride, float* out) {
  const std::size_t blocks = in.columns / kBlock;
  for (std::size_t t = 0; t < in.count; ++t) {
    __m256 even = _mm256_setzero_ps(), odd = _mm256_setzero_ps();
    const std::int8_t* row = in.bytes.data() + t * in.columns;
    const float* row_scales = in.scales.data() + t * blocks;
    std::size_t block = 0;
    for (; block + 2 <= blocks; block += 2) {
      const std::size_t at = block * kBlock, next = at + kBlock;
      even = _mm256_add_ps(
          even, ProductsByAvx2(weights + at, row + at, scales[block] * row_scales[block]));
      odd = _mm256_add_ps(odd, ProductsByAvx2(weights + next, row + next,
                                              scales[block + 1] * row_scales[block + 1]));
    }
    if (block < blocks) {
      const std::size_t at = block * kBlock;
      even = _mm256_add_ps(
          even, ProductsByAvx2(weights + at, row + at, scales[block] * row_scales[block]));
    }
    out[t * stride] = SumByAvx2(even, odd);
  }
}

#define LATTICEWORLD_VNNI __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl,avx512vnni")))

constexpr __mmask64 kBothBlocks = ~__mmask64{0}, kFirstBlock = 0xFFFFFFFFu;

// Adds the products of two blocks, or of one, of a row of weights with as many of kCount rows of
// activations: magnitudes of weights times activations with the weights' signs.
template <std::size_t kCount>
LATTICEWORLD_VNNI inline void AddByVnni(const std::int8_t* weights, const float* scales,
                                        __mmask64 bytes, const std::int8_t* rows,
                                        const float* row_scales, std::size_t columns,
                                        __m512* lanes) {
  const __m512i a = _mm512_maskz_loadu_epi8(bytes, weights);
  const __m512i magnitudes = _mm512_maskz_abs_epi8(kBothBlocks, a);
  const __mmask64 negative = _mm512_movepi8_mask(a);
  const __m512i zero = _mm512_setzero_si512();
  for (std::size_t k = 0; k < kCount; ++k) {
    const __m512i b = _mm512_maskz_loadu_epi8(bytes, rows + k * columns);
    const __m512i signs = _mm512_mask_sub_epi8(b, negative, zero, b);
    const __m512 sums =
        _mm512_maskz_cvtepi32_ps(0xFFFF, _mm512_dpbusd_epi32(zero, magnitudes, signs));
    const float* of_row = row_scales + k * (columns / kBlock);
    const __m512 first = _mm512_set1_ps(scales[0] * of_row[0]);
    if (bytes == kFirstBlock) {
      lanes[k] = _mm512_mask_add_ps(lanes[k], 0xFF, lanes[k], _mm512_mul_ps(sums, first));
      continue;
    }
    const __m512 second = _mm512_set1_ps(scales[1] * of_row[1]);
    const __m512 scale = _mm512_mask_mov_ps(first, 0xFF00, second);
    lanes[k] = _mm512_add_ps(lanes[k], _mm512_mul_ps(sums, scale));
  }
}

template <std::size_t kCount>
LATTICEWORLD_VNNI void RowsByVnni(const std::int8_t* weights, const float* scales,
                                  const std::int8_t* rows, const float* row_scales,
                                  std::size_t columns, std::size_t stride, float* out) {
  __m512 lanes[kCount];
  for (__m512& sums : lanes) sums = _mm512_setzero_ps();
  const std::size_t blocks = columns / kBlock;
  std::size_t block = 0;
  for (; block + 2 <= blocks; block += 2)
    AddByVnni<kCount>(weights + block * kBlock, scales + block, kBothBlocks, rows + block * kBlock,
                      row_scales + block, columns, lanes);
  if (block < blocks)
    AddByVnni<kCount>(weights + block * kBlock, scales + block, kFirstBlock, rows + block * kBlock,
                      row_scales + block, columns, lanes);
  for (std::size_t k = 0; k < kCount; ++k)
    out[k * stride] =
        SumByAvx2(_mm512_castps512_ps256(lanes[k]), _mm512_extractf32x8_ps(lanes[k], 1));
}

LATTICEWORLD_VNNI void RowByVnni(const std::int8_t* weights, const float* scales,
                                 const ByteRows& in, std::size_t stride, float* out) {
  constexpr std::size_t kTogether = 4;  // activations that share one reading of the weights
  const std::int8_t* rows = in.bytes.data();
  const float* row_scales = in.scales.data();
  const auto add = [&](auto count) LATTICEWORLD_VNNI {
    RowsByVnni<count>(weights, scales, rows, row_scales, in.columns, stride, out);
    rows += count * in.columns;
    row_scales += count * (in.columns / kBlock);
    out += count * stride;
  };
  std::size_t left = in.count;
  for (; left >= kTogether; left -= kTogether)
    add(std::integral_constant<std::size_t, kTogether>());
  for (; left > 0; --left) add(std::integral_constant<std::size_t, 1>());
}
#endif

using RowFunction = decltype(&RowPlainly);

RowFunction RowBy([[maybe_unused]] Instructions instructions) {
#ifdef LATTICEWORLD_HAS_VECTOR_ROWS
  if (instructions == Instructions::kVnni) return &RowByVnni;
  if (instructions != Instructions::kPlain) return &RowByAvx2;
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
    bool finite = true;
    for (std::size_t i = 0; i < kBlock; ++i) {
      most = std::max(most, std::abs(values[i]));
      finite = finite && std::isfinite(values[i]);
    }
    if (!finite) {  // no byte says so; the scale makes all products NaN
      rows.scales[block] = std::numeric_limits<float>::quiet_NaN();
      continue;
    }
    rows.scales[block] = RoundedToHalf(most / 127.0f);
    // What is too small for a scale is 0, as the reciprocal would be infinite.
    const float inverse = rows.scales[block] > 0.0f ? 127.0f / most : 0.0f;
    for (std::size_t i = 0; i < kBlock; ++i)
      bytes[i] = static_cast<std::int8_t>((values[i] * inverse + kRounder) - kRounder);
  }
  return rows;
}

void MultiplyBytes(const ByteWeights& weights, const ByteRows& in, std::size_t stride, float* out,
                   Instructions instructions) {
  const RowFunction row = RowBy(instructions);
  const std::size_t blocks = in.columns / kBlock;
  for (std::size_t r = 0; r < weights.rows; ++r)
    row(weights.bytes + r * in.columns, weights.scales + r * blocks, in, stride, out + r);
}

}  // namespace latticeworld
