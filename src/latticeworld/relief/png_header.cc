// Portable Network Graphics, W3C recommendation, second edition (ISO/IEC 15948:2003).
#include <array>
#include <string>

#include "latticeworld/common/text.h"
#include "latticeworld/relief/picture_header.h"

namespace latticeworld::internal {
namespace {

constexpr std::size_t kSignatureSize = 8;
constexpr std::size_t kChunkFrame = 12;  // length, type and CRC around a chunk's data

std::uint32_t BigEndian32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  }
  return value;
}

constexpr std::array<std::uint32_t, 256> MakeCrcTable() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t n = 0; n < 256; ++n) {
    std::uint32_t c = n;
    for (int k = 0; k < 8; ++k) c = (c & 1) != 0 ? 0xedb88320u ^ (c >> 1) : c >> 1;
    table[n] = c;
  }
  return table;
}

std::uint32_t Crc(std::string_view bytes) {
  static constexpr std::array<std::uint32_t, 256> kTable = MakeCrcTable();
  std::uint32_t crc = 0xffffffffu;
  for (const char byte : bytes) {
    crc = kTable[(crc ^ static_cast<unsigned char>(byte)) & 0xff] ^ (crc >> 8);
  }
  return ~crc;
}

std::string_view ColorTypeName(int color_type) {
  switch (color_type) {
    case 0:
      return "greyscale";
    case 2:
      return "colour (RGB)";
    case 3:
      return "a palette";
    case 4:
      return "greyscale with alpha";
    case 6:
      return "colour with alpha (RGBA)";
    default:
      return "an unknown colour type";
  }
}

Status CutOff(std::string_view where) {
  return InvalidArgument("the PNG height map is cut off " + std::string(where) +
                         "; a whole file that ends with its IEND chunk is needed");
}

// OpenCV fills what is missing of a cut file with zeros: walk the chunks to the end before it sees
// them.
Status CheckChunks(std::string_view bytes) {
  bool has_data = false;
  for (std::size_t at = kSignatureSize; at < bytes.size();) {
    if (bytes.size() - at < kChunkFrame) return CutOff("inside a chunk's header");
    const std::size_t length = BigEndian32(bytes, at);
    const std::string_view type = bytes.substr(at + 4, 4);
    if (length > bytes.size() - at - kChunkFrame) {
      return CutOff("inside its " + Quote(type) + " chunk (" + std::to_string(length) +
                    " bytes announced, " + std::to_string(bytes.size() - at - kChunkFrame) +
                    " left)");
    }
    if (Crc(bytes.substr(at + 4, length + 4)) != BigEndian32(bytes, at + 8 + length)) {
      return InvalidArgument("the PNG height map is damaged: the checksum of its " + Quote(type) +
                             " chunk is wrong");
    }
    if (type == "tRNS") {
      return InvalidArgument(
          "the PNG height map is greyscale with transparency; legal is greyscale without");
    }
    has_data = has_data || type == "IDAT";
    if (type == "IEND") {
      return has_data ? Status() : InvalidArgument("the PNG height map has no pixel data (IDAT)");
    }
    at += kChunkFrame + length;
  }
  return CutOff("before its IEND chunk");
}

}  // namespace

Result<PictureHeader> ReadPngHeader(std::string_view bytes) {
  constexpr std::size_t kHeaderSize = 13;
  if (bytes.size() < kSignatureSize + kChunkFrame + kHeaderSize) return CutOff("inside its header");
  if (bytes.substr(kSignatureSize + 4, 4) != "IHDR" ||
      BigEndian32(bytes, kSignatureSize) != kHeaderSize) {
    return InvalidArgument("the PNG height map does not start with an IHDR chunk of 13 bytes");
  }
  PictureHeader header;
  header.format = PictureFormat::kPng;
  header.width = BigEndian32(bytes, 16);
  header.height = BigEndian32(bytes, 20);
  header.bits = static_cast<unsigned char>(bytes[24]);
  const int color_type = static_cast<unsigned char>(bytes[25]);
  if (color_type != 0 || (header.bits != 8 && header.bits != 16)) {
    return InvalidArgument("the PNG height map is " + std::string(ColorTypeName(color_type)) +
                           " of " + std::to_string(header.bits) +
                           " bits; legal is greyscale of 8 or 16 bits");
  }
  LW_RETURN_IF_ERROR(CheckPictureSize(header.width, header.height));
  LW_RETURN_IF_ERROR(CheckChunks(bytes));
  return header;
}

}  // namespace latticeworld::internal
