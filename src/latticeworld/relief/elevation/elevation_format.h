#ifndef LATTICEWORLD_RELIEF_ELEVATION_ELEVATION_FORMAT_H_
#define LATTICEWORLD_RELIEF_ELEVATION_ELEVATION_FORMAT_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"

namespace latticeworld::internal {

inline constexpr int kMaxDataSide = 65536;  // samples a side of a file; at least 2

// No ground on the earth lies outside; what does stands for no-data.
inline constexpr double kLowestGround_m = -12000.0;
inline constexpr double kHighestGround_m = 9000.0;
// What writers put where they know nothing, also in files that do not say so.
inline constexpr float kUsualNoData = -9999.0f;

enum class ElevationFormat : std::uint8_t { kGeoTiff, kArcAscii, kSrtm };

// One degree by one degree: whole metres of two bytes, the greater first, row by row from the
// north. The outermost samples stand on the tile's edges.
struct SrtmTile {
  int south_deg = 0;  // of its south-west corner; north and east are positive
  int west_deg = 0;
  int cols = 0;
  int rows = 0;
};

struct ElevationFile {
  ElevationFormat format = ElevationFormat::kGeoTiff;
  SrtmTile tile;  // of an SRTM tile
};

// What the bytes are, before GDAL sees them. name: the file's own, with or without directories;
// only SRTM's say something: "N40W106.hgt" or "N40W106.SRTMGL1.hgt" is the tile whose south-west
// corner is 40 degrees north, 106 degrees west. Errors: INVALID_ARGUMENT saying what was given and
// what is legal.
Result<ElevationFile> RecognizeElevation(std::string_view bytes, std::string_view name);

// OK when both sides are in 2..kMaxDataSide.
Status CheckDataSize(std::int64_t cols, std::int64_t rows);

// An Arc/Info ASCII grid, checked and written anew.
struct ArcAsciiGrid {
  std::string text;             // the same grid, as GDAL reads it
  bool whole_numbers = true;    // no sample has decimals
  double height_range_m = 0.0;  // from the lowest to the highest of what can be ground, [0, 21000]
  std::vector<std::string> warnings;  // what was left out
};

// Reads an Arc/Info ASCII grid before GDAL does, which takes what is no number for 0, skips lines
// that begin with nan, puts a grid without a whole corner at (0, 0), and takes whole numbers beside
// inf for 32-bit integers. The grid's text has the keys ncols, nrows, xllcorner, yllcorner,
// cellsize (or dx and dy) and NODATA_value, a line a row, decimal points, and one number for
// no-data: for what the file declares to be none, else -9999, for nan, inf and null. Decimal commas
// are points where the file has no points. Takes up to about twice the bytes. Errors:
// INVALID_ARGUMENT saying what was given and what is legal (a key or number is wrong, missing or
// given twice, one corner with one center, points and commas, a size outside 2..65536, more or
// fewer numbers than that).
Result<ArcAsciiGrid> NormalizeArcAscii(std::string_view bytes);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_ELEVATION_ELEVATION_FORMAT_H_
