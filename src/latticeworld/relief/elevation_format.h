#ifndef LATTICEWORLD_RELIEF_ELEVATION_FORMAT_H_
#define LATTICEWORLD_RELIEF_ELEVATION_FORMAT_H_

#include <cstdint>
#include <string>
#include <string_view>

#include "latticeworld/common/result.h"

namespace latticeworld::internal {

inline constexpr int kMaxDataSide = 65536;  // samples a side of a file; at least 2

enum class ElevationFormat : std::uint8_t { kGeoTiff, kArcAscii, kSrtm };

struct ElevationFile {
  ElevationFormat format = ElevationFormat::kGeoTiff;
  std::string driver;     // GDAL's name of it
  std::string file_name;  // one that GDAL's driver knows its format by: "N40W106.hgt"
};

// What the bytes are, before GDAL sees them. name: the file's own, with or without directories;
// only SRTM's say something: "N40W106.hgt" or "N40W106.SRTMGL1.hgt" is the tile whose south-west
// corner is 40 degrees north, 106 degrees west. Errors: INVALID_ARGUMENT saying what was given and
// what is legal.
Result<ElevationFile> RecognizeElevation(std::string_view bytes, std::string_view name);

// OK when both sides are in 2..kMaxDataSide.
Status CheckDataSize(std::int64_t cols, std::int64_t rows);

// OK when an Arc/Info ASCII grid is whole: its size is legal and as many numbers follow as it asks
// for. GDAL takes what is no number for 0.
Status CheckArcAscii(std::string_view bytes);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_ELEVATION_FORMAT_H_
