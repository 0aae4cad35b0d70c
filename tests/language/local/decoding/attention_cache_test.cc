#include "latticeworld/language/local/decoding/attention_cache.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

std::vector<float> Noise(std::size_t size, const std::string& name) {
  RandomStream random(1, name);
  std::vector<float> noise(size);
  for (float& value : noise) value = static_cast<float>(random.Normal(0.0, 1.0));
  return noise;
}

// The textbook's attention in float64, of a head that begins `from` floats into each place.
std::vector<double> Attention(const float* query, const std::vector<float>& keys,
                              const std::vector<float>& values, std::size_t from,
                              std::size_t stride, std::size_t width, std::size_t length) {
  std::vector<double> shares;
  for (std::size_t i = 0; i < length; ++i) {
    double product = 0.0;
    for (std::size_t k = 0; k < width; ++k)
      product += double{query[k]} * keys[i * stride + from + k];
    shares.push_back(product / std::sqrt(static_cast<double>(width)));
  }
  const double highest = *std::max_element(shares.begin(), shares.end());
  double sum = 0.0;
  for (double& share : shares) sum += share = std::exp(share - highest);
  std::vector<double> out(width);
  for (std::size_t i = 0; i < length; ++i)
    for (std::size_t k = 0; k < width; ++k)
      out[k] += shares[i] / sum * values[i * stride + from + k];
  return out;
}

using Sizes = std::tuple<std::size_t, std::size_t>;  // heads, width
class AttentionCacheTest : public ::testing::TestWithParam<Sizes> {
 protected:
  static constexpr std::size_t kPlaces = 70;
  const std::size_t heads_ = std::get<0>(GetParam()), width_ = std::get<1>(GetParam());
  const std::size_t stride_ = heads_ * width_ + 3;
  const std::vector<float> keys_ = Noise(kPlaces * stride_, "keys");
  const std::vector<float> values_ = Noise(kPlaces * stride_, "values");
  const std::vector<float> query_ = Noise(width_, "query");

  std::vector<float> Looked(AttentionCache* cache, std::size_t head, std::size_t length) const {
    std::vector<float> out(width_);
    cache->Attend(head, query_.data(), length, out.data());
    return out;
  }
};

TEST_P(AttentionCacheTest, IsTheTextbooksAtEveryLength) {
  AttentionCache cache(heads_, width_);
  cache.Append(keys_.data(), values_.data(), stride_, kPlaces);
  ASSERT_EQ(cache.length(), kPlaces);
  for (std::size_t head = 0; head < heads_; ++head) {
    for (std::size_t length = 1; length <= kPlaces; ++length) {
      const std::vector<float> out = Looked(&cache, head, length);
      const std::vector<double> expected =
          Attention(query_.data(), keys_, values_, head * width_, stride_, width_, length);
      for (std::size_t k = 0; k < width_; ++k)
        ASSERT_NEAR(out[k], expected[k], 2e-5) << head << ", " << length << ", " << k;
    }
  }
}

TEST_P(AttentionCacheTest, IsTheSameHoweverThePlacesCame) {
  AttentionCache at_once(heads_, width_), one_by_one(heads_, width_), anew(heads_, width_);
  at_once.Append(keys_.data(), values_.data(), stride_, kPlaces);
  for (std::size_t i = 0; i < kPlaces; ++i)
    one_by_one.Append(keys_.data() + i * stride_, values_.data() + i * stride_, stride_, 1);
  // What was forgotten is as if it had never been.
  const std::vector<float> wrong(kPlaces * stride_, 1e6f);
  anew.Append(keys_.data(), values_.data(), stride_, 21);
  anew.Append(wrong.data(), wrong.data(), stride_, 30);
  anew.Truncate(21);
  ASSERT_EQ(anew.length(), 21u);
  EXPECT_EQ(Looked(&anew, 0, 21), Looked(&at_once, 0, 21));
  anew.Append(keys_.data() + 21 * stride_, values_.data() + 21 * stride_, stride_, kPlaces - 21);
  for (std::size_t head = 0; head < heads_; ++head) {
    for (const std::size_t length : {std::size_t{1}, std::size_t{16}, kPlaces}) {
      EXPECT_EQ(Looked(&one_by_one, head, length), Looked(&at_once, head, length));
      EXPECT_EQ(Looked(&anew, head, length), Looked(&at_once, head, length));
    }
  }
}

TEST_P(AttentionCacheTest, AKeyThatIsNoNumberSpoilsWhatLooksAtItAndNothingElse) {
  constexpr std::size_t kSpoilt = 40;
  for (const float value : {std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity() * query_[0]}) {
    std::vector<float> keys = keys_;
    keys[kSpoilt * stride_] = value;  // of the first head
    AttentionCache cache(heads_, width_), whole(heads_, width_);
    cache.Append(keys.data(), values_.data(), stride_, kPlaces);
    whole.Append(keys_.data(), values_.data(), stride_, kPlaces);
    for (const std::size_t length : {kSpoilt + 1, std::size_t{48}, kPlaces})
      for (const float number : Looked(&cache, 0, length)) EXPECT_TRUE(std::isnan(number));
    EXPECT_EQ(Looked(&cache, 0, kSpoilt), Looked(&whole, 0, kSpoilt));
    if (heads_ > 1) EXPECT_EQ(Looked(&cache, 1, kPlaces), Looked(&whole, 1, kPlaces));
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, AttentionCacheTest,
                         ::testing::Values(Sizes{1, 1}, Sizes{2, 6}, Sizes{3, 16}, Sizes{1, 32},
                                           Sizes{2, 50}, Sizes{1, 64}, Sizes{1, 80}));

TEST(AttentionTest, AHeadTakesTheValueOfTheKeyThatItsQueryPointsTo) {
  const std::vector<float> keys = {1, 0, -1, 0}, values = {5, 6, 7, 8}, query = {-100, 0};
  AttentionCache cache(1, 2);
  cache.Append(keys.data(), values.data(), 2, 2);
  std::vector<float> out(2);
  cache.Attend(0, query.data(), 2, out.data());
  EXPECT_NEAR(out[0], 7.0f, 1e-5);
  EXPECT_NEAR(out[1], 8.0f, 1e-5);
}

}  // namespace
}  // namespace latticeworld
