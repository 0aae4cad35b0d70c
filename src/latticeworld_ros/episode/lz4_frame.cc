#include "latticeworld_ros/episode/lz4_frame.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>

namespace latticeworld {
namespace {

// http://wiki.ros.org/Bags/Format/2.0: a line, then records of a header and data, each preceded by
// its length, little endian. A header is fields, each preceded by its length: NAME=VALUE.
constexpr std::uint32_t kMostHeaderBytes = 1u << 20;
constexpr char kChunkField[] = "op=\x05";
constexpr char kLz4Field[] = "compression=lz4";

// lz4_Frame_format.md: the magic number, then the flags.
constexpr std::uint32_t kMagic = 0x184D2204;
constexpr unsigned kVersionAndReservedBits = 0xC2, kVersion1 = 0x40;
constexpr unsigned kFlagsOfRoslz4 = 0x64;  // version 1, independent blocks, content checksum

std::optional<std::uint32_t> ReadNumber(std::istream* in) {
  std::array<char, 4> bytes{};
  if (!in->read(bytes.data(), bytes.size())) return std::nullopt;
  std::uint32_t number = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) {
    number = number << 8 | static_cast<unsigned char>(bytes[i]);
  }
  return number;
}

bool HasField(const std::string& header, const std::string& wanted) {
  std::size_t at = 0;
  while (at + 4 <= header.size()) {
    std::uint32_t length = 0;
    for (std::size_t i = 4; i-- > 0;) {
      length = length << 8 | static_cast<unsigned char>(header[at + i]);
    }
    at += 4;
    if (length > header.size() - at) return false;
    if (header.compare(at, length, wanted) == 0) return true;
    at += length;
  }
  return false;
}

bool IsForeignFrame(std::istream* in) {
  const auto magic = ReadNumber(in);
  const int flags = in->get();
  if (magic != kMagic || flags == std::istream::traits_type::eof()) return false;
  const auto bits = static_cast<unsigned>(flags);
  return (bits & kVersionAndReservedBits) == kVersion1 && bits != kFlagsOfRoslz4;
}

}  // namespace

bool HasForeignLz4Frame(const std::filesystem::path& bag) {
  std::ifstream in(bag, std::ios::binary);
  std::string line;
  if (!std::getline(in, line)) return false;
  for (;;) {
    const auto header_bytes = ReadNumber(&in);
    if (!header_bytes || *header_bytes > kMostHeaderBytes) return false;
    std::string header(*header_bytes, '\0');
    if (!in.read(header.data(), *header_bytes)) return false;
    const auto data_bytes = ReadNumber(&in);
    if (!data_bytes) return false;
    const std::streampos data = in.tellg();
    if (HasField(header, kChunkField) && HasField(header, kLz4Field) && IsForeignFrame(&in)) {
      return true;
    }
    if (!in.seekg(data + static_cast<std::streamoff>(*data_bytes))) return false;
  }
}

}  // namespace latticeworld
