#include "latticeworld/relief/elevation/elevation_format.h"

#include <algorithm>
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

// Tiles of two bytes a sample, with the edges on both sides. Beyond 50 degrees of latitude those of
// 1 arc second have samples every 2 arc seconds from west to east.
struct SrtmSize {
  int cols;
  int rows;
  std::string_view spacing;
  std::size_t bytes() const { return std::size_t{2} * cols * rows; }
};
constexpr SrtmSize kSrtmSizes[] = {
    {3601, 3601, "1 arc second"},
    {1201, 1201, "3 arc seconds"},
    {1801, 3601, "2 x 1 arc seconds, beyond 50 degrees north or south"},
    {7201, 7201, "half an arc second"}};

// nullptr: no tile has that size.
const SrtmSize* SrtmSizeOf(std::size_t bytes) {
  const auto* const size =
      std::find_if(std::begin(kSrtmSizes), std::end(kSrtmSizes),
                   [bytes](const SrtmSize& one) { return one.bytes() == bytes; });
  return size == std::end(kSrtmSizes) ? nullptr : size;
}

bool IsTiff(std::string_view bytes) {
  return StartsWith(bytes, "II*\0"sv) || StartsWith(bytes, "MM\0*"sv) ||
         StartsWith(bytes, "II+\0"sv) || StartsWith(bytes, "MM\0+"sv);
}

// Whether the first word is a key of such a grid's header, whose keys have no order.
bool IsArcAscii(std::string_view bytes) {
  constexpr std::string_view kKeys[] = {"ncols",     "nrows",     "xllcorner",   "yllcorner",
                                        "xllcenter", "yllcenter", "cellsize",    "dx",
                                        "dy",        "nodata",    "nodata_value"};
  const std::string_view start = bytes.substr(0, 16);
  const std::string word = ToLowerAscii(start.substr(0, start.find_first_of(" \t\r\n")));
  return std::find(std::begin(kKeys), std::end(kKeys), word) != std::end(kKeys);
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

// The corner of "N40W106...", when the name says so; without a size.
std::optional<SrtmTile> CornerOf(std::string_view name) {
  const std::string tile = ToLowerAscii(BaseName(name).substr(0, 7));
  // -1: no such number.
  const auto number = [&tile](std::size_t at, std::size_t count, int most) {
    int value = 0;
    for (std::size_t i = at; i < at + count; ++i) {
      if (std::isdigit(static_cast<unsigned char>(tile[i])) == 0) return -1;
      value = 10 * value + (tile[i] - '0');
    }
    return value <= most ? value : -1;
  };
  const bool letters =
      tile.size() == 7 && (tile[0] == 'n' || tile[0] == 's') && (tile[3] == 'e' || tile[3] == 'w');
  if (!letters) return std::nullopt;
  const int latitude_deg = number(1, 2, 90), longitude_deg = number(4, 3, 180);
  if (latitude_deg < 0 || longitude_deg < 0) return std::nullopt;
  SrtmTile corner;
  corner.south_deg = tile[0] == 'n' ? latitude_deg : -latitude_deg;
  corner.west_deg = tile[3] == 'e' ? longitude_deg : -longitude_deg;
  return corner;
}

Result<ElevationFile> RecognizeSrtm(std::string_view bytes, std::string_view name) {
  std::optional<SrtmTile> tile = CornerOf(name);
  if (!tile) {
    return InvalidArgument("the SRTM elevation is called " + Quote(BaseName(name)) +
                           ", which does not say where it lies; legal are names like "
                           "\"N40W106.hgt\", the latitude and longitude of its south-west corner");
  }
  if (const SrtmSize* const size = SrtmSizeOf(bytes.size())) {
    tile->cols = size->cols;
    tile->rows = size->rows;
    return ElevationFile{ElevationFormat::kSrtm, *tile};
  }
  std::string legal;
  for (const SrtmSize& known : kSrtmSizes) {
    legal += (legal.empty() ? "" : ", ") + std::to_string(known.bytes()) + " (" +
             std::to_string(known.cols) + " x " + std::to_string(known.rows) + " samples, " +
             std::string(known.spacing) + ")";
  }
  return InvalidArgument("the SRTM elevation is " + std::to_string(bytes.size()) +
                         " bytes long; legal are " + legal +
                         ": it is cut off or of another format");
}

}  // namespace

Result<ElevationFile> RecognizeElevation(std::string_view bytes, std::string_view name) {
  if (IsTiff(bytes)) return ElevationFile{ElevationFormat::kGeoTiff, {}};
  if (IsArcAscii(bytes)) return ElevationFile{ElevationFormat::kArcAscii, {}};
  const bool srtm_name = EndsWith(ToLowerAscii(name), ".hgt");
  if (!bytes.empty() && (srtm_name || SrtmSizeOf(bytes.size()) != nullptr)) {
    return RecognizeSrtm(bytes, name);
  }
  return InvalidArgument("the elevation " + Describe(bytes) + kLegal);
}

Status CheckDataSize(std::int64_t cols, std::int64_t rows) {
  const auto legal = [](std::int64_t side) { return side >= 2 && side <= kMaxDataSide; };
  if (legal(cols) && legal(rows)) return Status();
  return InvalidArgument("the elevation is " + std::to_string(cols) + " x " + std::to_string(rows) +
                         " samples; legal are 2 to " + std::to_string(kMaxDataSide) + " a side");
}

}  // namespace latticeworld::internal
