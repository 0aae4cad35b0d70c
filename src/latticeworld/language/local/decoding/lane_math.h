#ifndef LATTICEWORLD_LANGUAGE_LOCAL_DECODING_LANE_MATH_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_DECODING_LANE_MATH_H_

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "latticeworld/language/local/weights/instructions.h"

// Sums over floats in sixteen lanes, which the compiler lays out for each kind of processor. The
// order of additions is the same on all of them, so that the same file gives the same answers.

// Stands before what WithLanes runs, and before all that it calls: it becomes a part of the
// function that is made for a kind of processor.
#define LATTICEWORLD_LANE_INLINE inline __attribute__((always_inline))

namespace latticeworld {

#if defined(__x86_64__) && defined(__GNUC__)
template <typename Sums, typename... Arguments>
__attribute__((target("avx2"))) void WithAvx2(Arguments... arguments) {
  Sums::Run(arguments...);
}

template <typename Sums, typename... Arguments>
__attribute__((target("avx512f,avx512bw,avx512dq,avx512vl"))) void WithAvx512(
    Arguments... arguments) {
  Sums::Run(arguments...);
}
#endif

// Calls Sums::Run, a LATTICEWORLD_LANE_INLINE function, as it is made for the instructions in use.
template <typename Sums, typename... Arguments>
void WithLanes(Arguments... arguments) {
#if defined(__x86_64__) && defined(__GNUC__)
  const Instructions used = UsedInstructions();
  if (used >= Instructions::kAvx512) return WithAvx512<Sums>(arguments...);
  if (used == Instructions::kAvx2) return WithAvx2<Sums>(arguments...);
#endif
  Sums::Run(arguments...);
}

constexpr std::size_t kLanes = 16;
using FloatLanes = float __attribute__((vector_size(64)));
using Int32Lanes = std::int32_t __attribute__((vector_size(64)));
using Int16Lanes = std::int16_t __attribute__((vector_size(32)));
using Int8Lanes = std::int8_t __attribute__((vector_size(16)));

template <typename Lanes, typename T>
LATTICEWORLD_LANE_INLINE void LoadLanes(const T* from, Lanes* lanes) {
  std::memcpy(lanes, from, sizeof(Lanes));
}

LATTICEWORLD_LANE_INLINE float SumOfLanes(const FloatLanes& lanes) {
  float half[kLanes / 2];
  for (std::size_t i = 0; i < kLanes / 2; ++i) half[i] = lanes[i] + lanes[i + kLanes / 2];
  for (std::size_t width = kLanes / 4; width > 0; width /= 2)
    for (std::size_t i = 0; i < width; ++i) half[i] += half[i + width];
  return half[0];
}

// kCount dot products of one row with as many others, `stride` floats apart;
// size: any.
template <int kCount>
LATTICEWORLD_LANE_INLINE void DotProducts(const float* row, const float* others, std::size_t stride,
                                          std::size_t size, float* out) {
  FloatLanes sums[kCount] = {};
  const std::size_t whole = size / kLanes * kLanes;
  for (std::size_t i = 0; i < whole; i += kLanes) {
    FloatLanes weights;
    LoadLanes(row + i, &weights);
    for (int k = 0; k < kCount; ++k) {
      FloatLanes values;
      LoadLanes(others + k * stride + i, &values);
      sums[k] += weights * values;
    }
  }
  for (int k = 0; k < kCount; ++k) {
    float sum = SumOfLanes(sums[k]);
    for (std::size_t i = whole; i < size; ++i) sum += row[i] * others[k * stride + i];
    out[k] = sum;
  }
}

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

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_DECODING_LANE_MATH_H_
