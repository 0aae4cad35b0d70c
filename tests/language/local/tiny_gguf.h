#ifndef LATTICEWORLD_TESTS_LANGUAGE_LOCAL_TINY_GGUF_H_
#define LATTICEWORLD_TESTS_LANGUAGE_LOCAL_TINY_GGUF_H_

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"

// What makes GGUF files with random weights, for tests.
namespace latticeworld::tiny {

inline constexpr std::size_t kAlignment = 32;
enum Kind : std::uint32_t {
  kUint32 = 4,
  kInt32 = 5,
  kFloat32 = 6,
  kBool = 7,
  kString = 8,
  kArray = 9
};

template <typename T>
std::string Raw(T value) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return bytes;
}

inline std::string Text(const std::string& text) { return Raw<std::uint64_t>(text.size()) + text; }

inline std::uint16_t Half(float value) {
  // Of numbers that are normal as float16, cut, of infinities and of what is no number.
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  const auto exponent = static_cast<int>((bits >> 23) & 0xFF) - 112;
  if (exponent <= 0) return 0;
  if (!std::isfinite(value))
    return std::isnan(value) ? 0x7E00u : ((bits >> 16) & 0x8000u) | 0x7C00u;
  return static_cast<std::uint16_t>(((bits >> 16) & 0x8000u) |
                                    (static_cast<std::uint32_t>(exponent) << 10) |
                                    ((bits >> 13) & 0x3FFu));
}

inline std::string Stored(const std::vector<float>& values, std::uint32_t type) {
  std::string bytes;
  if (type == 0)
    for (const float value : values) bytes += Raw(value);
  if (type == 1)
    for (const float value : values) bytes += Raw(Half(value));
  if (type == 8) {
    for (std::size_t at = 0; at < values.size(); at += 32) {
      float most = 0.0f;
      for (std::size_t i = 0; i < 32; ++i)
        if (!(std::abs(values[at + i]) <= most)) most = std::abs(values[at + i]);
      bytes += Raw(Half(most / 127.0f));
      // What is not finite is so by the scale.
      for (std::size_t i = 0; i < 32; ++i)
        bytes += Raw(static_cast<std::int8_t>(
            std::isfinite(most) ? std::lround(values[at + i] * 127.0f / most)
                                : std::lround(std::copysign(1.0f, values[at + i]))));
    }
  }
  return bytes;
}

// Collects keys and tensors, all but those `without`; File() is the file. Each weight of the tensor
// `spoilt` is `spoilt_with`.
class GgufWriter {
 public:
  GgufWriter(std::uint64_t seed, std::uint32_t weight_type, std::vector<std::string> without,
             std::string spoilt = {}, float spoilt_with = 1.0f)
      : weight_type_(weight_type),
        without_(std::move(without)),
        spoilt_(std::move(spoilt)),
        spoilt_with_(spoilt_with),
        random_(seed, "tiny model") {}

  void Entry(const std::string& key, std::uint32_t kind, const std::string& value) {
    if (LeftOut(key)) return;
    entries_ += Text(key) + Raw(kind) + value;
    ++entry_count_;
  }
  void Number(const std::string& key, std::size_t value) {
    Entry(key, kUint32, Raw(static_cast<std::uint32_t>(value)));
  }
  void Weights(const std::string& name, std::size_t rows, std::size_t columns, bool is_norm) {
    if (LeftOut(name)) return;
    std::vector<float> values(rows * columns);
    for (float& value : values)
      value = static_cast<float>(is_norm ? random_.Uniform(0.5, 1.5)
                                         : random_.Normal(0.0, 1.0 / std::sqrt(columns)));
    if (name == spoilt_) std::fill(values.begin(), values.end(), spoilt_with_);
    const std::uint32_t type = is_norm ? 0 : weight_type_;
    data_.resize((data_.size() + kAlignment - 1) / kAlignment * kAlignment);
    infos_ += Text(name) + Raw<std::uint32_t>(is_norm ? 1 : 2) + Raw<std::uint64_t>(columns);
    if (!is_norm) infos_ += Raw<std::uint64_t>(rows);
    infos_ += Raw(type) + Raw<std::uint64_t>(data_.size());
    data_ += Stored(values, type);
    ++tensor_count_;
  }
  std::string File() const {
    std::string file = "GGUF" + Raw<std::uint32_t>(3) + Raw<std::uint64_t>(tensor_count_) +
                       Raw<std::uint64_t>(entry_count_) + entries_ + infos_;
    file.resize((file.size() + kAlignment - 1) / kAlignment * kAlignment);
    return file + data_;
  }

 private:
  bool LeftOut(const std::string& name) const {
    return std::find(without_.begin(), without_.end(), name) != without_.end();
  }

  const std::uint32_t weight_type_;
  const std::vector<std::string> without_;
  const std::string spoilt_;
  const float spoilt_with_;
  RandomStream random_;
  std::string entries_, infos_, data_;
  std::uint64_t entry_count_ = 0, tensor_count_ = 0;
};

}  // namespace latticeworld::tiny

#endif  // LATTICEWORLD_TESTS_LANGUAGE_LOCAL_TINY_GGUF_H_
