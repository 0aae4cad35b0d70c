#include "latticeworld/language/local/weights/weight_matrix.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

#include "language/local/tiny_model.h"
#include "latticeworld/common/random.h"
#include "latticeworld/language/local/weights/gguf_file.h"

namespace latticeworld {
namespace {

std::vector<float> Noise(std::size_t size, RandomStream* random) {
  std::vector<float> values(size);
  for (float& value : values) value = static_cast<float>(random->Normal(0.0, 1.0));
  return values;
}

class WeightMatrixTest : public testing::TestWithParam<std::uint32_t> {
 protected:
  WeightMatrixTest() {
    TinyModel model;
    model.weight_type = GetParam();
    const ModelFile file(TinyGguf(model));
    auto opened = GgufFile::Open(file.path());
    EXPECT_TRUE(opened.ok()) << opened.status().ToString();
    gate_ = WeightMatrix(*opened->Tensor("blk.0.ffn_gate.weight", model.hidden, model.width));
  }
  WeightMatrix gate_;
};

TEST_P(WeightMatrixTest, MultipliesAsItsRowsSay) {
  RandomStream random(7, "activations");
  const std::vector<float> in = Noise(5 * gate_.columns(), &random);
  std::vector<float> out(5 * gate_.rows());
  gate_.Multiply(in.data(), 5, out.data());
  std::vector<float> row(gate_.columns());
  // Activations of int8 are off by half a step of 127 at most.
  const double tolerance = GetParam() == 8 ? 0.05 : 1e-4;
  for (std::size_t r = 0; r < gate_.rows(); ++r) {
    gate_.Row(r, row.data());
    for (std::size_t t = 0; t < 5; ++t) {
      double sum = 0.0;
      for (std::size_t i = 0; i < row.size(); ++i) sum += double{row[i]} * in[t * row.size() + i];
      EXPECT_NEAR(out[t * gate_.rows() + r], sum, tolerance);
    }
  }
}

TEST_P(WeightMatrixTest, GivesTheSameBitsHoweverRowsAreSplit) {
  RandomStream random(8, "activations");
  const std::vector<float> in = Noise(7 * gate_.columns(), &random);
  std::vector<float> together(7 * gate_.rows()), single(gate_.rows());
  gate_.Multiply(in.data(), 7, together.data());
  for (std::size_t t = 0; t < 7; ++t) {
    gate_.Multiply(in.data() + t * gate_.columns(), 1, single.data());
    for (std::size_t r = 0; r < gate_.rows(); ++r)
      EXPECT_EQ(together[t * gate_.rows() + r], single[r]);
  }
}

INSTANTIATE_TEST_SUITE_P(Types, WeightMatrixTest, testing::Values(0u, 1u, 8u));

TEST(FromHalfTest, ReadsEveryKindOfNumber) {
  EXPECT_EQ(FromHalf(0x0000), 0.0f);
  EXPECT_EQ(FromHalf(0x3C00), 1.0f);
  EXPECT_EQ(FromHalf(0xC000), -2.0f);
  EXPECT_EQ(FromHalf(0x7BFF), 65504.0f);
  EXPECT_EQ(FromHalf(0x0001), std::ldexp(1.0f, -24));
  EXPECT_EQ(FromHalf(0x83FF), -std::ldexp(1023.0f, -24));
  EXPECT_TRUE(std::isinf(FromHalf(0x7C00)));
  EXPECT_TRUE(std::isnan(FromHalf(0x7E00)));
}

// A block of q4_1: step 0.5, least value -2; the lower halves of its bytes come first.
TEST(HalfByteWeightsTest, BecomeBytesOfAScale) {
  std::vector<std::byte> block(kQ4BlockBytes);
  const std::uint16_t step = 0x3800, least = 0xC000;  // 0.5 and -2 as float16
  std::memcpy(block.data(), &step, sizeof(step));
  std::memcpy(block.data() + 2, &least, sizeof(least));
  for (std::size_t i = 0; i < 16; ++i) block[4 + i] = static_cast<std::byte>(i | (15 - i) << 4);
  const WeightMatrix weights({GgufType::kQ4_1, 1, 32, block.data()});
  std::vector<float> row(32);
  weights.Row(0, row.data());
  const double half_a_step = 5.5 / 127.0 / 2.0;
  for (int i = 0; i < 16; ++i) {
    EXPECT_NEAR(row[i], 0.5 * i - 2.0, half_a_step);
    EXPECT_NEAR(row[i + 16], 0.5 * (15 - i) - 2.0, half_a_step);
  }
}

TEST(HalfByteWeightsTest, ADamagedBlockIsNoNumber) {
  std::vector<std::byte> block(kQ4BlockBytes);
  const std::uint16_t infinite = 0x7C00;
  std::memcpy(block.data(), &infinite, sizeof(infinite));
  const WeightMatrix weights({GgufType::kQ4_1, 1, 32, block.data()});
  std::vector<float> row(32);
  weights.Row(0, row.data());
  EXPECT_TRUE(std::isnan(row[3]));
}

}  // namespace
}  // namespace latticeworld
