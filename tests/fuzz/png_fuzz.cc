// PNG pictures, as height maps and as sketches. Checksums of chunks are mended first, for no random
// change would get past them.

#include <zlib.h>

#include "fuzz/support/picture_reading.h"

namespace {

constexpr std::size_t kSignature = 8, kFrame = 12;

void PutBigEndian(std::uint32_t value, char* bytes) {
  for (int i = 0; i < 4; ++i) bytes[i] = static_cast<char>(value >> (24 - 8 * i));
}

std::uint32_t BigEndian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

std::string WithChecksums(std::string_view png) {
  std::string mended(png);
  for (std::size_t at = kSignature; at + kFrame <= mended.size();) {
    const std::size_t length = BigEndian(png.substr(at));
    if (length > mended.size() - at - kFrame) break;
    const auto* const chunk = reinterpret_cast<const unsigned char*>(mended.data()) + at + 4;
    const auto checksum = static_cast<std::uint32_t>(
        crc32(crc32(0, nullptr, 0), chunk, static_cast<unsigned>(length + 4)));
    PutBigEndian(checksum, mended.data() + at + 8 + length);
    at += kFrame + length;
  }
  return mended;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  latticeworld::fuzz::ReadAsPictures(WithChecksums(latticeworld::fuzz::TextOf(data, size)));
  return 0;
}
