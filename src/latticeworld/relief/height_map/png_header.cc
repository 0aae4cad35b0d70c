// Portable Network Graphics, W3C recommendation, second edition (ISO/IEC 15948:2003).
#include <array>
#include <string>

#include "latticeworld/common/text.h"
#include "latticeworld/relief/height_map/picture_header.h"

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

Status CutOff(std::string_view what, std::string_view where) {
  return InvalidArgument("the PNG " + std::string(what) + " is cut off " + std::string(where) +
                         "; a whole file that ends with its IEND chunk is needed");
}

// Width, height and bits of the IHDR chunk that a PNG starts with.
Result<PictureHeader> ReadStart(std::string_view bytes, std::string_view what) {
  constexpr std::size_t kHeaderSize = 13;
  if (bytes.size() < kSignatureSize + kChunkFrame + kHeaderSize) {
    return CutOff(what, "inside its header");
  }
  if (bytes.substr(kSignatureSize + 4, 4) != "IHDR" ||
      BigEndian32(bytes, kSignatureSize) != kHeaderSize) {
    return InvalidArgument("the PNG " + std::string(what) +
                           " does not start with an IHDR chunk of 13 bytes");
  }
  PictureHeader header;
  header.format = PictureFormat::kPng;
  header.width = BigEndian32(bytes, 16);
  header.height = BigEndian32(bytes, 20);
  header.bits = static_cast<unsigned char>(bytes[24]);
  return header;
}

// OpenCV fills what is missing of a cut file with zeros: walk the chunks to the end before it sees
// them. has_transparency: whether there is a tRNS chunk.
Status CheckChunks(std::string_view bytes, std::string_view what, bool* has_transparency) {
  bool has_data = false;
  for (std::size_t at = kSignatureSize; at < bytes.size();) {
    if (bytes.size() - at < kChunkFrame) return CutOff(what, "inside a chunk's header");
    const std::size_t length = BigEndian32(bytes, at);
    const std::string_view type = bytes.substr(at + 4, 4);
    if (length > bytes.size() - at - kChunkFrame) {
      return CutOff(what, "inside its " + Quote(type) + " chunk (" + std::to_string(length) +
                              " bytes announced, " +
                              std::to_string(bytes.size() - at - kChunkFrame) + " left)");
    }
    if (Crc(bytes.substr(at + 4, length + 4)) != BigEndian32(bytes, at + 8 + length)) {
      return InvalidArgument("the PNG " + std::string(what) + " is damaged: the checksum of its " +
                             Quote(type) + " chunk is wrong");
    }
    *has_transparency = *has_transparency || type == "tRNS";
    has_data = has_data || type == "IDAT";
    if (type == "IEND") {
      if (has_data) return Status();
      return InvalidArgument("the PNG " + std::string(what) + " has no pixel data (IDAT)");
    }
    at += kChunkFrame + length;
  }
  return CutOff(what, "before its IEND chunk");
}

}  // namespace

Result<PictureHeader> ReadColourPngHeader(std::string_view bytes, std::string_view what) {
  LW_ASSIGN_OR_RETURN(const PictureHeader header, ReadStart(bytes, what));
  LW_RETURN_IF_ERROR(CheckPictureSize(header.width, header.height, what));
  bool has_transparency = false;
  LW_RETURN_IF_ERROR(CheckChunks(bytes, what, &has_transparency));
  return header;
}

Result<PictureHeader> ReadPngHeader(std::string_view bytes) {
  constexpr std::string_view kWhat = "height map";
  LW_ASSIGN_OR_RETURN(const PictureHeader header, ReadStart(bytes, kWhat));
  const int color_type = static_cast<unsigned char>(bytes[25]);
  if (color_type != 0 || (header.bits != 8 && header.bits != 16)) {
    return InvalidArgument("the PNG height map is " + std::string(ColorTypeName(color_type)) +
                           " of " + std::to_string(header.bits) +
                           " bits; legal is greyscale of 8 or 16 bits");
  }
  LW_RETURN_IF_ERROR(CheckPictureSize(header.width, header.height, kWhat));
  bool has_transparency = false;
  LW_RETURN_IF_ERROR(CheckChunks(bytes, kWhat, &has_transparency));
  if (has_transparency) {
    return InvalidArgument(
        "the PNG height map is greyscale with transparency; legal is greyscale without");
  }
  return header;
}

}  // namespace latticeworld::internal
