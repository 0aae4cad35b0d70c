#ifndef LATTICEWORLD_RELIEF_HEIGHT_MAP_PICTURE_HEADER_H_
#define LATTICEWORLD_RELIEF_HEIGHT_MAP_PICTURE_HEADER_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "latticeworld/common/result.h"

namespace latticeworld::internal {

enum class PictureFormat : std::uint8_t { kPng, kPgm, kTiff, kJpeg };

struct PictureHeader {
  PictureFormat format = PictureFormat::kPng;
  std::int64_t width = 0;  // samples
  std::int64_t height = 0;
  int bits = 0;  // of a sample
};

// What a height map's file says about itself, read without decoding pixels, and whether the file is
// whole. Errors: INVALID_ARGUMENT saying what was given and what is legal (not a PNG, PGM or TIFF;
// colour, alpha, palette, other depths; a size outside 33..8193; cut off or damaged).
Result<PictureHeader> ReadPictureHeader(std::string_view bytes);

// The parts of it, one a format; bytes begin with the format's signature.
Result<PictureHeader> ReadPngHeader(std::string_view bytes);
Result<PictureHeader> ReadPgmHeader(std::string_view bytes);
Result<PictureHeader> ReadTiffHeader(std::string_view bytes);

// The same for a picture of any colours: a PNG, JPEG or TIFF of any kind that is whole. what: what
// it is for messages, "sketch".
Result<PictureHeader> ReadColourPictureHeader(std::string_view bytes, std::string_view what);
Result<PictureHeader> ReadColourPngHeader(std::string_view bytes, std::string_view what);
Result<PictureHeader> ReadJpegHeader(std::string_view bytes, std::string_view what);
Result<PictureHeader> ReadColourTiffHeader(std::string_view bytes, std::string_view what);

// OK when both sides are in 33..8193. Each format checks its size before anything that grows with
// it.
Status CheckPictureSize(std::int64_t width, std::int64_t height, std::string_view what);

// What a file of the wrong kind probably is: "a GIF", "not a picture (12 bytes that start with
// ...)".
std::string DescribeFile(std::string_view bytes);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_HEIGHT_MAP_PICTURE_HEADER_H_
