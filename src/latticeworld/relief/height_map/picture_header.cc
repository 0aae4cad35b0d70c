#include "latticeworld/relief/height_map/picture_header.h"

#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld::internal {

std::string DescribeFile(std::string_view bytes) {
  using namespace std::string_view_literals;
  constexpr std::pair<std::string_view, std::string_view> kKnown[] = {
      {"\x89PNG\r\n\x1a\n"sv, "a PNG"},
      {"\xff\xd8\xff"sv, "a JPEG"},
      {"II*\0"sv, "a TIFF"},
      {"MM\0*"sv, "a TIFF"},
      {"GIF8"sv, "a GIF"},
      {"BM"sv, "a BMP"},
      {"RIFF"sv, "a WebP or another RIFF file"},
      {"P1"sv, "a PBM (black and white)"},
      {"P2"sv, "a PGM (greyscale)"},
      {"P3"sv, "a PPM (colour)"},
      {"P4"sv, "a PBM (black and white)"},
      {"P5"sv, "a PGM (greyscale)"},
      {"P6"sv, "a PPM (colour)"},
      {"II+\0"sv, "a BigTIFF"},
      {"MM\0+"sv, "a BigTIFF"},
      {"\x1f\x8b"sv, "a gzip archive"},
      {"%PDF"sv, "a PDF"},
  };
  for (const auto& [signature, name] : kKnown) {
    if (StartsWith(bytes, signature)) return std::string(name);
  }
  if (bytes.empty()) return "empty (0 bytes)";
  return "not a picture (" + std::to_string(bytes.size()) + " bytes that start with " +
         Quote(bytes.substr(0, 8)) + ")";
}

Status CheckPictureSize(std::int64_t width, std::int64_t height, std::string_view what) {
  const auto legal = [](std::int64_t side) {
    return side >= kMinReliefSize && side <= kMaxReliefSize;
  };
  if (legal(width) && legal(height)) return Status();
  return InvalidArgument("the " + std::string(what) + " is " + std::to_string(width) + " x " +
                         std::to_string(height) + " samples; legal are " +
                         std::to_string(kMinReliefSize) + " to " + std::to_string(kMaxReliefSize) +
                         " a side");
}

Result<PictureHeader> ReadPictureHeader(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (StartsWith(bytes, "\x89PNG\r\n\x1a\n"sv)) return ReadPngHeader(bytes);
  if (StartsWith(bytes, "P5"sv) || StartsWith(bytes, "P2"sv)) return ReadPgmHeader(bytes);
  if (StartsWith(bytes, "II*\0"sv) || StartsWith(bytes, "MM\0*"sv)) return ReadTiffHeader(bytes);
  return InvalidArgument("the height map is " + DescribeFile(bytes) +
                         "; legal are 8-bit and 16-bit greyscale PNG, PGM and TIFF");
}

}  // namespace latticeworld::internal
