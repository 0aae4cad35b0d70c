#include "viewer/stream_decoder.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>

namespace latticeworld {
namespace {

// The bytes of a frame, one number after the other, the lowest byte first.
class Bytes {
 public:
  explicit Bytes(const std::string& bytes) : bytes_(bytes) {}

  std::uint64_t Number(int count) {
    std::uint64_t value = 0;
    for (int i = 0; i < count; ++i) value |= static_cast<std::uint64_t>(Byte()) << (8 * i);
    return value;
  }
  std::int64_t Varint() {
    std::uint64_t value = 0;
    unsigned char byte = 0x80;
    for (int shift = 0; (byte & 0x80) != 0 && shift < 64; shift += 7) {
      byte = Byte();
      value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
    }
    return static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1);
  }
  bool at_end() const { return next_ == bytes_.size(); }

 private:
  unsigned char Byte() {
    if (next_ < bytes_.size()) return static_cast<unsigned char>(bytes_[next_++]);
    ADD_FAILURE() << "a frame ends too early, after " << bytes_.size() << " bytes";
    return 0;
  }
  const std::string& bytes_;
  std::size_t next_ = 0;
};

}  // namespace

bool StreamDecoder::Read(const std::string& frame) {
  Bytes bytes(frame);
  kind_ = static_cast<int>(bytes.Number(1));
  is_key_ = bytes.Number(1) == 1;
  const auto key_number = static_cast<std::uint16_t>(bytes.Number(2));
  const auto version = static_cast<std::uint32_t>(bytes.Number(4));
  const std::uint64_t time_bits = bytes.Number(8);
  const auto count = static_cast<std::size_t>(bytes.Number(2));
  if (!is_key_ && (!has_key_ || key_number != key_number_ || version != version_)) return false;
  std::memcpy(&time_s_, &time_bits, sizeof(time_s_));
  if (is_key_) {
    key_.assign(count, {});
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t index = bytes.Number(2);
      EXPECT_EQ(index, i);
      StreamedThing& thing = key_[i];
      for (auto& value : thing.position_cm) value = static_cast<std::int32_t>(bytes.Number(4));
      for (auto& value : thing.angle) value = static_cast<std::uint16_t>(bytes.Number(2));
      thing.behaviour = static_cast<std::uint8_t>(bytes.Number(1));
      thing.health = static_cast<std::uint8_t>(bytes.Number(1));
    }
    has_key_ = true;
    key_number_ = key_number;
    version_ = version;
    things_ = key_;
  } else {
    things_ = key_;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t index = bytes.Number(2);
      const std::uint64_t mask = bytes.Number(1);
      if (index >= things_.size()) {
        ADD_FAILURE() << "index " << index << " of " << things_.size();
        return false;
      }
      StreamedThing& thing = things_[index];
      for (int axis = 0; axis < 3; ++axis) {
        if ((mask >> axis & 1) != 0) {
          thing.position_cm[axis] += static_cast<std::int32_t>(bytes.Varint());
        }
      }
      for (int axis = 0; axis < 3; ++axis) {
        if ((mask >> (3 + axis) & 1) != 0) {
          thing.angle[axis] = static_cast<std::uint16_t>(bytes.Number(2));
        }
      }
      if ((mask & 64) != 0) thing.behaviour = static_cast<std::uint8_t>(bytes.Number(1));
      if ((mask & 128) != 0) thing.health = static_cast<std::uint8_t>(bytes.Number(1));
    }
  }
  EXPECT_TRUE(bytes.at_end()) << "a frame goes on after its entries";
  return true;
}

}  // namespace latticeworld
