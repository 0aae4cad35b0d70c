#include "latticeworld/language/local/weights/byte_rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

constexpr std::size_t kRows = 5, kCount = 7;

// A multiplication of noise, whose bytes take every value.
class ByteRowsTest : public ::testing::TestWithParam<std::size_t> {
 protected:
  ByteRowsTest() {
    RandomStream random(3, "bytes");
    for (std::size_t i = 0; i < kRows * columns_; ++i)
      bytes_.push_back(static_cast<std::int8_t>(random.UniformInt(-128, 127)));
    for (std::size_t i = 0; i < kRows * columns_ / 32; ++i)
      scales_.push_back(static_cast<float>(random.Uniform(0.001, 0.1)));
    std::vector<float> in;
    for (std::size_t i = 0; i < kCount * columns_; ++i)
      in.push_back(static_cast<float>(random.Normal(0.0, 1.0)));
    rows_ = RoundToBytes(in.data(), kCount, columns_);
  }

  std::vector<float> Multiplied(Instructions instructions) const {
    std::vector<float> out(kCount * kRows);
    MultiplyBytes({bytes_.data(), scales_.data(), kRows}, rows_, kRows, out.data(), instructions);
    return out;
  }

  const std::size_t columns_ = GetParam();
  std::vector<std::int8_t> bytes_;
  std::vector<float> scales_;
  ByteRows rows_;
};

TEST_P(ByteRowsTest, ProductsAreThoseOfTheNumbersThatBytesStandFor) {
  const std::vector<float> out = Multiplied(Instructions::kPlain);
  const std::size_t blocks = columns_ / 32;
  for (std::size_t t = 0; t < kCount; ++t) {
    for (std::size_t r = 0; r < kRows; ++r) {
      double sum = 0.0, magnitude = 0.0;
      for (std::size_t i = 0; i < columns_; ++i) {
        const double product = double{scales_[r * blocks + i / 32]} * bytes_[r * columns_ + i] *
                               rows_.scales[t * blocks + i / 32] * rows_.bytes[t * columns_ + i];
        sum += product;
        magnitude += std::abs(product);
      }
      EXPECT_NEAR(out[t * kRows + r], sum, 1e-6 * magnitude) << t << ", " << r;
    }
  }
}

TEST_P(ByteRowsTest, AllInstructionsOfThisProcessorGiveTheSameBits) {
  const std::vector<float> plain = Multiplied(Instructions::kPlain);
  for (const auto instructions : kAllInstructions) {
    if (HasInstructions(instructions)) EXPECT_EQ(Multiplied(instructions), plain);
  }
  EXPECT_TRUE(HasInstructions(FastestInstructions()));
}

TEST_P(ByteRowsTest, WhatIsNoNumberSpoilsEveryProductOfItsRowAndNoOther) {
  for (const float value :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
        -std::numeric_limits<float>::infinity()}) {
    std::vector<float> in(2 * columns_, 1.0f);
    in[columns_ - 1] = value;
    const ByteRows rows = RoundToBytes(in.data(), 2, columns_);
    for (const auto instructions : kAllInstructions) {
      if (!HasInstructions(instructions)) continue;
      std::vector<float> out(2 * kRows);
      MultiplyBytes({bytes_.data(), scales_.data(), kRows}, rows, kRows, out.data(), instructions);
      for (std::size_t r = 0; r < kRows; ++r) {
        EXPECT_TRUE(std::isnan(out[r])) << value << ", " << r;
        EXPECT_TRUE(std::isfinite(out[kRows + r])) << value << ", " << r;
      }
    }
  }
}

TEST_P(ByteRowsTest, WhatIsTooSmallForAScaleIsNothing) {
  for (const float value : {1e-7f, 1e-37f, 1e-44f}) {
    const std::vector<float> in(columns_, value);
    const ByteRows rows = RoundToBytes(in.data(), 1, columns_);
    for (const float scale : rows.scales) EXPECT_EQ(scale, 0.0f) << value;
    for (const std::int8_t byte : rows.bytes) EXPECT_EQ(byte, 0) << value;
  }
}

// Even and odd numbers of blocks, and one alone.
INSTANTIATE_TEST_SUITE_P(Columns, ByteRowsTest, ::testing::Values(32, 64, 96, 352, 1024));

}  // namespace
}  // namespace latticeworld
