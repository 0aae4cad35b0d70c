#ifndef LATTICEWORLD_RELIEF_PICTURE_HEADER_H_
#define LATTICEWORLD_RELIEF_PICTURE_HEADER_H_

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "latticeworld/common/result.h"

namespace latticeworld::internal {

enum class PictureFormat : std::uint8_t { kPng, kPgm, kTiff };

struct PictureHeader {
  PictureFormat format = PictureFormat::kPng;
  std::int64_t width = 0;  // samples
  std::int64_t height = 0;
  int bits = 0;  // 8 or 16
};

// What a height map's file says about itself, read without decoding pixels, and whether the file is
// whole. Errors: INVALID_ARGUMENT saying what was given and what is legal (not a PNG, PGM or TIFF;
// colour, alpha, palette, other depths; a size outside 33..8193; cut off or damaged).
Result<PictureHeader> ReadPictureHeader(std::string_view bytes);

// The parts of it, one a format; bytes begin with the format's signature.
Result<PictureHeader> ReadPngHeader(std::string_view bytes);
Result<PictureHeader> ReadPgmHeader(std::string_view bytes);
Result<PictureHeader> ReadTiffHeader(std::string_view bytes);

// OK when both sides are in 33..8193. Each format checks its size before anything that grows with
// it.
Status CheckPictureSize(std::int64_t width, std::int64_t height);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_PICTURE_HEADER_H_
