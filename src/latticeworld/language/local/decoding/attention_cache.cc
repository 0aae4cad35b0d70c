#include "latticeworld/language/local/decoding/attention_cache.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/language/local/decoding/lane_math.h"

namespace latticeworld {
namespace {

constexpr std::size_t kAtOnce = 4;  // sums that grow side by side, none waiting for another

std::size_t RoundedUp(std::size_t size) { return (size + kLanes - 1) / kLanes * kLanes; }

// The products of a query with the keys of `blocks` blocks; the greatest of the first `length`.
LATTICEWORLD_LANE_INLINE float Products(const float* query, const float* keys, std::size_t width,
                                        std::size_t length, float* out) {
  FloatLanes highest = FloatLanes{} - 1e30f;
  for (std::size_t begin = 0; begin < length; begin += kLanes, keys += width * kLanes) {
    FloatLanes sums[kAtOnce] = {};
    std::size_t i = 0;
    for (; i + kAtOnce <= width; i += kAtOnce) {
      for (std::size_t k = 0; k < kAtOnce; ++k) {
        FloatLanes numbers;
        LoadLanes(keys + (i + k) * kLanes, &numbers);
        sums[k] += numbers * query[i + k];
      }
    }
    for (; i < width; ++i) {
      FloatLanes numbers;
      LoadLanes(keys + i * kLanes, &numbers);
      sums[0] += numbers * query[i];
    }
    const FloatLanes products = (sums[0] + sums[1]) + (sums[2] + sums[3]);
    std::memcpy(out + begin, &products, sizeof(products));
    if (begin + kLanes <= length) highest = products > highest ? products : highest;
  }
  float most = highest[0];
  for (std::size_t k = 1; k < kLanes; ++k) most = std::max(most, highest[k]);
  for (std::size_t i = length / kLanes * kLanes; i < length; ++i) most = std::max(most, out[i]);
  return most;
}

// Makes products shares that are not yet divided by their sum, which is the answer. Room beyond
// `length` to the next sixteen becomes 0.
LATTICEWORLD_LANE_INLINE float Shares(float highest, float scale, std::size_t length,
                                      float* products) {
  FloatLanes sums = {};
  const std::size_t end = RoundedUp(length);
  for (std::size_t i = length; i < end; ++i) products[i] = highest - 1e6f / scale;
  for (std::size_t i = 0; i < end; i += kLanes) {
    FloatLanes lanes;
    LoadLanes(products + i, &lanes);
    lanes = (lanes - highest) * scale;
    ExpOfLanes(&lanes);
    sums += lanes;
    std::memcpy(products + i, &lanes, sizeof(lanes));
  }
  return SumOfLanes(sums);
}

// kWide times sixteen numbers of the values, weighed by their shares.
template <std::size_t kWide>
LATTICEWORLD_LANE_INLINE void Weigh(const float* shares, const float* values, std::size_t stride,
                                    std::size_t length, float* out) {
  FloatLanes sums[kAtOnce][kWide] = {};
  std::size_t place = 0;
  for (; place + kAtOnce <= length; place += kAtOnce) {
    for (std::size_t i = 0; i < kAtOnce; ++i) {
      for (std::size_t k = 0; k < kWide; ++k) {
        FloatLanes numbers;
        LoadLanes(values + (place + i) * stride + k * kLanes, &numbers);
        sums[i][k] += numbers * shares[place + i];
      }
    }
  }
  for (; place < length; ++place) {
    for (std::size_t k = 0; k < kWide; ++k) {
      FloatLanes numbers;
      LoadLanes(values + place * stride + k * kLanes, &numbers);
      sums[0][k] += numbers * shares[place];
    }
  }
  for (std::size_t k = 0; k < kWide; ++k) {
    const FloatLanes sum = (sums[0][k] + sums[1][k]) + (sums[2][k] + sums[3][k]);
    std::memcpy(out + k * kLanes, &sum, sizeof(sum));
  }
}

// One head looking back; shares: room for `length` rounded up; sums: for the padded width.
struct LookBack {
  LATTICEWORLD_LANE_INLINE static void Run(const float* query, const float* keys,
                                           const float* values, std::size_t width,
                                           std::size_t padded_width, std::size_t length,
                                           float* shares, float* sums) {
    const float highest = Products(query, keys, width, length, shares);
    const float scale = 1.0f / std::sqrt(static_cast<float>(width));
    const float inverse = 1.0f / Shares(highest, scale, length, shares);
    std::size_t k = 0;
    for (; k + 2 * kLanes <= padded_width; k += 2 * kLanes)
      Weigh<2>(shares, values + k, padded_width, length, sums + k);
    if (k < padded_width) Weigh<1>(shares, values + k, padded_width, length, sums + k);
    for (std::size_t i = 0; i < width; ++i) sums[i] *= inverse;
  }
};

}  // namespace

AttentionCache::AttentionCache(std::size_t heads, std::size_t width)
    : width_(width), padded_width_(RoundedUp(width)), heads_(heads) {}

void AttentionCache::Append(const float* keys, const float* values, std::size_t stride,
                            std::size_t count) {
  const std::size_t length = length_ + count;
  for (Head& head : heads_) {
    head.keys.resize(RoundedUp(length) * width_);
    head.values.resize(length * padded_width_);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t place = length_ + i;
      float* key = head.keys.data() + place / kLanes * width_ * kLanes + place % kLanes;
      for (std::size_t k = 0; k < width_; ++k) key[k * kLanes] = keys[i * stride + k];
      std::copy_n(values + i * stride, width_, head.values.data() + place * padded_width_);
    }
    keys += width_;
    values += width_;
  }
  length_ = length;
}

void AttentionCache::Reserve(std::size_t places) {
  for (Head& head : heads_) {
    head.keys.reserve(RoundedUp(places) * width_);
    head.values.reserve(places * padded_width_);
  }
}

void AttentionCache::Truncate(std::size_t length) {
  length_ = std::min(length, length_);
  for (Head& head : heads_) {
    head.keys.resize(RoundedUp(length_) * width_);
    head.values.resize(length_ * padded_width_);
  }
}

void AttentionCache::Attend(std::size_t head, const float* query, std::size_t length,
                            float* out) const {
  // Kept from call to call: a token looks back some hundred times.
  thread_local std::vector<float> shares, sums;
  shares.resize(std::max(shares.size(), RoundedUp(length)));
  sums.resize(std::max(sums.size(), padded_width_));
  const Head& looked_at = heads_[head];
  WithLanes<LookBack>(query, looked_at.keys.data(), looked_at.values.data(), width_, padded_width_,
                      length, shares.data(), sums.data());
  std::copy_n(sums.data(), width_, out);
}

}  // namespace latticeworld
