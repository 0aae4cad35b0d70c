#include "latticeworld/language/local/weights/weight_matrix.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "latticeworld/common/work_crew.h"
#include "latticeworld/language/local/decoding/lane_math.h"
#include "latticeworld/language/local/weights/byte_rows.h"

namespace latticeworld {
namespace {

constexpr std::size_t kBlock = kQ8BlockValues;
constexpr int kTogether = 4;  // activations that share one reading of a row
// A part of a multiplication takes as long as handing it out at least, and a thread that is slow
// or elsewhere leaves its share to the others.
constexpr std::size_t kLeastProducts = 16384;
constexpr int kPartsEach = 4;

struct FloatRows {
  LATTICEWORLD_LANE_INLINE static void Run(const float* weights, std::size_t rows,
                                           std::size_t columns, const float* in, std::size_t count,
                                           std::size_t stride, float* out) {
    for (std::size_t r = 0; r < rows; ++r) {
      const float* row = weights + r * columns;
      std::size_t t = 0;
      for (; t + kTogether <= count; t += kTogether) {
        float dots[kTogether];
        DotProducts<kTogether>(row, in + t * columns, columns, columns, dots);
        for (int k = 0; k < kTogether; ++k) out[(t + k) * stride + r] = dots[k];
      }
      for (; t < count; ++t)
        DotProducts<1>(row, in + t * columns, columns, columns, out + t * stride + r);
    }
  }
};

}  // namespace

float FromHalf(std::uint16_t bits) {
  const std::uint32_t sign = static_cast<std::uint32_t>(bits & 0x8000u) << 16;
  const std::uint32_t exponent = (bits >> 10) & 0x1Fu;
  const std::uint32_t fraction = bits & 0x3FFu;
  if (exponent == 0) {  // zero and what is below the least normal number
    const float magnitude = std::ldexp(static_cast<float>(fraction), -24);
    return sign != 0 ? -magnitude : magnitude;
  }
  const std::uint32_t wide = exponent == 31 ? sign | 0x7F800000u | (fraction << 13)
                                            : sign | ((exponent + 112) << 23) | (fraction << 13);
  float value;
  std::memcpy(&value, &wide, sizeof(value));
  return value;
}

namespace {

// The values of a block of q4_1: the lower halves of its bytes, then the upper ones.
std::array<float, kBlock> HalfByteValues(const std::byte* block) {
  std::uint16_t step = 0;
  std::uint16_t least = 0;
  std::memcpy(&step, block, sizeof(step));
  std::memcpy(&least, block + sizeof(step), sizeof(least));
  std::array<float, kBlock> values{};
  for (std::size_t i = 0; i < kBlock / 2; ++i) {
    const auto both = static_cast<unsigned>(block[4 + i]);
    values[i] = FromHalf(step) * static_cast<float>(both & 15u) + FromHalf(least);
    values[i + kBlock / 2] = FromHalf(step) * static_cast<float>(both >> 4) + FromHalf(least);
  }
  return values;
}

}  // namespace

WeightMatrix::WeightMatrix(const GgufTensor& tensor)
    : rows_(tensor.rows), columns_(tensor.columns) {
  const std::size_t size = rows_ * columns_;
  // Blocks of bytes are kept as they are.
  if (tensor.type == GgufType::kQ8_0) {
    bytes_.resize(size);
    scales_.resize(size / kBlock);
    for (std::size_t block = 0; block < scales_.size(); ++block) {
      const std::byte* from = tensor.data + block * kQ8BlockBytes;
      std::uint16_t scale;
      std::memcpy(&scale, from, sizeof(scale));
      scales_[block] = FromHalf(scale);
      std::memcpy(bytes_.data() + block * kBlock, from + sizeof(scale), kBlock);
    }
    return;
  }
  // Blocks of half bytes are rounded to bytes by their largest magnitude.
  if (tensor.type == GgufType::kQ4_1) {
    bytes_.resize(size);
    scales_.resize(size / kBlock);
    for (std::size_t block = 0; block < scales_.size(); ++block) {
      const std::array<float, kBlock> values = HalfByteValues(tensor.data + block * kQ4BlockBytes);
      float largest = 0.0f;
      bool finite = true;
      for (const float value : values) {
        finite = finite && std::isfinite(value);
        largest = std::max(largest, std::abs(value));
      }
      if (!finite) {  // a damaged block spoils what it is multiplied with, as it would by itself
        scales_[block] = std::numeric_limits<float>::quiet_NaN();
        std::fill_n(bytes_.data() + block * kBlock, kBlock, std::int8_t{1});
        continue;
      }
      scales_[block] = largest / 127.0f;
      for (std::size_t i = 0; i < kBlock; ++i) {
        const float scaled = largest > 0.0f ? values[i] / scales_[block] : 0.0f;
        bytes_[block * kBlock + i] = static_cast<std::int8_t>(std::lround(scaled));
      }
    }
    return;
  }
  // Floating-point weights are kept as floats, float16 widened.
  floats_.resize(size);
  if (tensor.type == GgufType::kFloat32) {
    std::memcpy(floats_.data(), tensor.data, size * sizeof(float));
    return;
  }
  for (std::size_t i = 0; i < size; ++i) {
    std::uint16_t half;
    std::memcpy(&half, tensor.data + i * sizeof(half), sizeof(half));
    floats_[i] = FromHalf(half);
  }
}

void WeightMatrix::Row(std::size_t row, float* out) const {
  if (!floats_.empty()) {
    std::copy_n(floats_.data() + row * columns_, columns_, out);
    return;
  }
  for (std::size_t i = 0; i < columns_; ++i) {
    const std::size_t at = row * columns_ + i;
    out[i] = static_cast<float>(bytes_[at]) * scales_[at / kBlock];
  }
}

void WeightMatrix::MultiplyRows(std::size_t begin, std::size_t end, const float* in,
                                const ByteRows& rounded, std::size_t count, float* out) const {
  if (!floats_.empty()) {
    WithLanes<FloatRows>(floats_.data() + begin * columns_, end - begin, columns_, in, count, rows_,
                         out + begin);
    return;
  }
  const ByteWeights weights = {bytes_.data() + begin * columns_,
                               scales_.data() + begin * (columns_ / kBlock), end - begin};
  MultiplyBytes(weights, rounded, rows_, out + begin);
}

void WeightMatrix::Multiply(const float* in, std::size_t count, float* out, WorkCrew* crew) const {
  const ByteRows rounded = floats_.empty() ? RoundToBytes(in, count, columns_) : ByteRows();
  const std::size_t products = rows_ * columns_ * count;
  const std::size_t worth = std::min(products / kLeastProducts, rows_);
  const int parts =
      crew == nullptr ? 1 : std::clamp(static_cast<int>(worth), 1, kPartsEach * crew->threads());
  if (parts == 1) {
    MultiplyRows(0, rows_, in, rounded, count, out);
    return;
  }
  crew->Run(parts, [&](int part) {
    MultiplyRows(rows_ * part / parts, rows_ * (part + 1) / parts, in, rounded, count, out);
  });
}

}  // namespace latticeworld
