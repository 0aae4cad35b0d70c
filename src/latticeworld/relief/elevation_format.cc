#include "latticeworld/relief/elevation_format.h"

#include <array>
#include <cctype>
#include <cstddef>
#include <optional>
#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld::internal {
namespace {

using namespace std::string_view_literals;

constexpr char kLegal[] =
    "; legal are GeoTIFF, SRTM .hgt and Arc/Info ASCII grid (ncols, nrows, ... then numbers)";

// Two bytes a sample, squares of 1 and of 3 arc seconds with the edges on both sides.
constexpr std::array<std::size_t, 2> kSrtmSides = {3601, 1201};
constexpr std::size_t SrtmBytes(std::size_t side) { return 2 * side * side; }

bool IsTiff(std::string_view bytes) {
  return StartsWith(bytes, "II*\0"sv) || StartsWith(bytes, "MM\0*"sv) ||
         StartsWith(bytes, "II+\0"sv) || StartsWith(bytes, "MM\0+"sv);
}

bool IsArcAscii(std::string_view bytes) {
  constexpr std::string_view kKeys[] = {"ncols",     "nrows",     "xllcorner", "yllcorner",
                                        "xllcenter", "yllcenter", "cellsize",  "nodata_value"};
  const std::string start = ToLowerAscii(bytes.substr(0, 16));
  for (const std::string_view key : kKeys) {
    if (StartsWith(start, key)) return true;
  }
  return false;
}

// What a file that holds no elevation probably is.
std::string Describe(std::string_view bytes) {
  constexpr std::pair<std::string_view, std::string_view> kKnown[] = {
      {"PK\x03\x04"sv, "a ZIP archive; unpack it"},
      {"\x1f\x8b"sv, "a gzip archive; unpack it"},
      {"\x89PNG"sv, "a PNG picture, which has no place on the earth"},
      {"\xff\xd8\xff"sv, "a JPEG picture"},
      {"P5"sv, "a PGM picture, which has no place on the earth"},
      {"P2"sv, "a PGM picture, which has no place on the earth"},
      {"\x89HDF"sv, "an HDF5 or NetCDF file"},
      {"CDF"sv, "a NetCDF file"},
      {"<VRT"sv, "a GDAL virtual raster, which only names other files"},
      {"<"sv, "an XML or HTML file"},
      {"%PDF"sv, "a PDF"},
  };
  if (bytes.empty()) return "is empty (0 bytes)";
  for (const auto& [signature, name] : kKnown) {
    if (StartsWith(bytes, signature)) return "is " + std::string(name);
  }
  return "is not such a file (" + std::to_string(bytes.size()) + " bytes that start with " +
         Quote(bytes.substr(0, 8)) + ")";
}

std::string_view BaseName(std::string_view name) {
  const std::size_t slash = name.find_last_of("/\\");
  return slash == std::string_view::npos ? name : name.substr(slash + 1);
}

// "N40W106", when the name says so.
std::optional<std::string> TileOf(std::string_view name) {
  std::string tile(BaseName(name).substr(0, 7));
  for (char& c : tile) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  const auto digits = [&tile](std::size_t at, std::size_t count, int most) {
    int value = 0;
    for (std::size_t i = at; i < at + count; ++i) {
      if (std::isdigit(static_cast<unsigned char>(tile[i])) == 0) return false;
      value = 10 * value + (tile[i] - '0');
    }
    return value <= most;
  };
  const bool legal = tile.size() == 7 && (tile[0] == 'N' || tile[0] == 'S') &&
                     (tile[3] == 'E' || tile[3] == 'W') && digits(1, 2, 90) && digits(4, 3, 180);
  if (!legal) return std::nullopt;
  return tile;
}

Result<ElevationFile> RecognizeSrtm(std::string_view bytes, std::string_view name) {
  const auto tile = TileOf(name);
  if (!tile) {
    return InvalidArgument("the SRTM elevation is called " + Quote(BaseName(name)) +
                           ", which does not say where it lies; legal are names like "
                           "\"N40W106.hgt\", the latitude and longitude of its south-west corner");
  }
  for (const std::size_t side : kSrtmSides) {
    if (bytes.size() == SrtmBytes(side)) {
      return ElevationFile{ElevationFormat::kSrtm, "SRTMHGT", *tile + ".hgt"};
    }
  }
  return InvalidArgument("the SRTM elevation is " + std::to_string(bytes.size()) +
                         " bytes long; legal are " + std::to_string(SrtmBytes(kSrtmSides[0])) +
                         " (3601 x 3601 samples, 1 arc second) and " +
                         std::to_string(SrtmBytes(kSrtmSides[1])) +
                         " (1201 x 1201 samples, 3 arc seconds): it is cut off or of another "
                         "format");
}

}  // namespace

Result<ElevationFile> RecognizeElevation(std::string_view bytes, std::string_view name) {
  if (IsTiff(bytes)) return ElevationFile{ElevationFormat::kGeoTiff, "GTiff", "data.tif"};
  if (IsArcAscii(bytes)) return ElevationFile{ElevationFormat::kArcAscii, "AAIGrid", "data.asc"};
  const bool srtm_name = EndsWith(ToLowerAscii(name), ".hgt");
  bool srtm_size = false;
  for (const std::size_t side : kSrtmSides) srtm_size |= bytes.size() == SrtmBytes(side);
  if (!bytes.empty() && (srtm_name || srtm_size)) return RecognizeSrtm(bytes, name);
  return InvalidArgument("the elevation " + Describe(bytes) + kLegal);
}

Status CheckDataSize(std::int64_t cols, std::int64_t rows) {
  const auto legal = [](std::int64_t side) { return side >= 2 && side <= kMaxDataSide; };
  if (legal(cols) && legal(rows)) return Status();
  return InvalidArgument("the elevation is " + std::to_string(cols) + " x " + std::to_string(rows) +
                         " samples; legal are 2 to " + std::to_string(kMaxDataSide) + " a side");
}

}  // namespace latticeworld::internal
