#include "latticeworld/relief/elevation/elevation_raster.h"

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/relief/elevation/elevation_format.h"
#include "latticeworld/relief/elevation/gdal_errors.h"

namespace latticeworld::internal {
namespace {

// A file is decoded block by block (strip or tile), so this bounds what a small file asks for.
constexpr std::int64_t kMaxBlockBytes = std::int64_t{256} << 20;
constexpr std::int64_t kChunkSamples = std::int64_t{8} << 20;  // read at once

// Metres a unit of height; nullopt: not known. The empty unit is the metre, as GeoTIFF and SRTM
// mean it.
std::optional<double> MetresOf(std::string_view unit) {
  constexpr double kFoot = 0.3048;
  constexpr double kSurveyFoot = 1200.0 / 3937.0;
  constexpr std::pair<std::string_view, double> kUnits[] = {
      {"", 1.0},
      {"m", 1.0},
      {"metre", 1.0},
      {"metres", 1.0},
      {"meter", 1.0},
      {"meters", 1.0},
      {"cm", 0.01},
      {"centimetre", 0.01},
      {"centimeter", 0.01},
      {"dm", 0.1},
      {"decimetre", 0.1},
      {"decimeter", 0.1},
      {"mm", 0.001},
      {"millimetre", 0.001},
      {"millimeter", 0.001},
      {"km", 1000.0},
      {"kilometre", 1000.0},
      {"kilometer", 1000.0},
      {"ft", kFoot},
      {"foot", kFoot},
      {"feet", kFoot},
      {"international foot", kFoot},
      {"us ft", kSurveyFoot},
      {"ftus", kSurveyFoot},
      {"us foot", kSurveyFoot},
      {"us survey foot", kSurveyFoot},
      {"us survey feet", kSurveyFoot},
      {"foot us", kSurveyFoot},
      {"foot us survey", kSurveyFoot},
      {"us surveyfoot", kSurveyFoot},
  };
  // Signs that files write in unlike ways are made alike.
  std::string plain = ToLowerAscii(unit);
  std::replace_if(
      plain.begin(), plain.end(), [](char c) { return c == '_' || c == '-'; }, ' ');
  plain.erase(std::remove_if(plain.begin(), plain.end(),
                             [](char c) { return c == '(' || c == ')' || c == '.'; }),
              plain.end());
  for (const auto& [name, metres] : kUnits) {
    if (plain == name) return metres;
  }
  return std::nullopt;
}

std::string WellKnownText(OGRSpatialReferenceH crs) {
  char* text = nullptr;
  const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
  std::string result;
  if (OSRExportToWktEx(crs, &text, options) == OGRERR_NONE && text != nullptr) result = text;
  CPLFree(text);
  return result;
}

bool LiesOnTheEarth(const std::array<double, 6>& t, int cols, int rows) {
  return t[0] >= -180.5 && t[0] + t[1] * cols <= 360.5 && t[3] <= 90.5 &&
         t[3] + t[5] * rows >= -90.5;
}

// What an ASCII grid's numbers say about its coordinates.
struct GridNumbers {
  std::array<double, 6> transform;
  int cols;
  int rows;
  double height_range_m;

  double width() const { return std::abs(transform[1]) * cols; }
  double length() const { return std::abs(transform[5]) * rows; }
};

// Degrees, by the look of them: what SRTM tiles become when they are written as text without a CRS.
// Heights tell them from surveys in local metres with cells of centimetres: land rises by a few
// times its width at most, and where it rises by less than 3 m in a degree (111 km) it is no land.
// A survey often begins at (0, 0), where as degrees there is the Gulf of Guinea. Nobody surveys a
// centimetre.
bool LooksLikeDegrees(const GridNumbers& grid) {
  constexpr double kLargestCell = 0.1;
  constexpr double kSmallestSurvey = 0.01;
  constexpr double kSteepest = 3.0;
  constexpr double kSteepestAtZero = 100.0;
  const std::array<double, 6>& t = grid.transform;
  if (std::abs(t[1]) >= kLargestCell || std::abs(t[5]) >= kLargestCell ||
      !LiesOnTheEarth(t, grid.cols, grid.rows)) {
    return false;
  }
  const double extent = std::max(grid.width(), grid.length());
  if (extent < kSmallestSurvey) return true;
  const double west = t[0], south = t[3] + t[5] * grid.rows;
  const bool at_zero = std::abs(west) < 1e-9 && std::abs(south) < 1e-9;
  if (grid.height_range_m == 0.0) return !at_zero;
  return grid.height_range_m > (at_zero ? kSteepestAtZero : kSteepest) * extent;
}

std::string Rounded(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof(buffer), "%.6g", value);
  return buffer;
}

// How the coordinates were taken, by what, and how to say otherwise.
std::string JudgedWarning(const GridNumbers& grid, bool degrees) {
  constexpr double kDegree_m = 111e3;  // of latitude
  const std::array<double, 6>& t = grid.transform;
  const std::string numbers = "the elevation has no coordinate system: by its numbers (cells of " +
                              Rounded(std::abs(t[1])) + " x " + Rounded(std::abs(t[5])) + ", " +
                              Rounded(grid.width()) + " x " + Rounded(grid.length()) +
                              " in all, heights that differ by " + Rounded(grid.height_range_m) +
                              " m) it is taken for ";
  if (!degrees) {
    return numbers +
           "metres, and the world lies nowhere on the earth; elevation unit degrees "
           "(--elevation-unit, elevation_unit) takes it otherwise";
  }
  char cell_m[32];
  std::snprintf(cell_m, sizeof(cell_m), "%.2g", std::abs(t[5]) * kDegree_m);
  return numbers + "degrees (WGS 84), so that a cell is about " + cell_m +
         " m from north to south; elevation unit metres (--elevation-unit, elevation_unit) takes "
         "it otherwise";
}

}  // namespace

// The file in GDAL's memory file system, opened. Its name there holds its own address, so that no
// other that is open has it. An SRTM tile is a raster in memory without a file.
struct ElevationRaster::File {
  std::string name;  // empty: there is no file
  ElevationFormat format = ElevationFormat::kGeoTiff;
  bool in_memory = false;
  GDALDatasetH dataset = nullptr;
  GDALRasterBandH band = nullptr;
  double scale_m = 1.0;  // height [m] = offset_m + scale_m * sample
  double offset_m = 0.0;
  ElevationUnit coordinates = ElevationUnit::kJudged;
  ArcAsciiGrid ascii;  // what GDAL reads of an ASCII grid
  GeoReference reference;
  std::vector<std::string> warnings;

  ~File() {
    const GdalErrors errors;
    if (dataset != nullptr) GDALClose(dataset);
    if (in_memory) VSIUnlink(name.c_str());
  }

  Status Open(std::string_view bytes, const ElevationFile& file);
  Status Decode(std::string_view bytes);
  Status CopyTile(std::string_view bytes, const SrtmTile& tile);
  Status CheckBands();
  Status CheckBlocks() const;
  Status ReadHeightUnit();
  Status ReadReference();
};

Status ElevationRaster::File::Open(std::string_view bytes, const ElevationFile& file) {
  format = file.format;
  LW_RETURN_IF_ERROR(format == ElevationFormat::kSrtm ? CopyTile(bytes, file.tile) : Decode(bytes));
  LW_RETURN_IF_ERROR(CheckDataSize(GDALGetRasterXSize(dataset), GDALGetRasterYSize(dataset)));
  LW_RETURN_IF_ERROR(CheckBands());
  LW_RETURN_IF_ERROR(CheckBlocks());
  LW_RETURN_IF_ERROR(ReadReference());
  return ReadHeightUnit();
}

Status ElevationRaster::File::Decode(std::string_view bytes) {
  const bool ascii_grid = format == ElevationFormat::kArcAscii;
  name = "/vsimem/latticeworld-" + std::to_string(reinterpret_cast<std::uintptr_t>(this)) +
         (ascii_grid ? "/data.asc" : "/data.tif");
  const GdalErrors errors;
  // GDAL only reads it; its interface has no const buffer.
  auto* data = reinterpret_cast<GByte*>(const_cast<char*>(bytes.data()));
  VSILFILE* memory = VSIFileFromMemBuffer(name.c_str(), data, bytes.size(), FALSE);
  if (memory == nullptr) return Internal("cannot open the elevation in memory" + errors.Last(name));
  in_memory = true;
  VSIFCloseL(memory);

  const char* const drivers[] = {ascii_grid ? "AAIGrid" : "GTiff", nullptr};
  const char* const no_siblings[] = {nullptr};
  // Without this option GDAL looks at some numbers only to find out their type.
  const char* const any_numbers[] = {"DATATYPE=Float64", nullptr};
  dataset = GDALOpenEx(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers,
                       ascii_grid ? any_numbers : nullptr, no_siblings);
  if (dataset != nullptr) return Status();
  return InvalidArgument("the elevation cannot be read, it is cut off or damaged" +
                         errors.Last(name));
}

// Reads the tile itself, since versions of GDAL know different sizes of tiles (3.6.2 none of half
// an arc second).
Status ElevationRaster::File::CopyTile(std::string_view bytes, const SrtmTile& tile) {
  constexpr double kVoid = -32768.0;
  const GdalErrors errors;
  dataset = GDALCreate(GDALGetDriverByName("MEM"), "", tile.cols, tile.rows, 1, GDT_Int16, nullptr);
  if (dataset == nullptr) return ResourceExhausted("no room for the elevation" + errors.Last(""));
  GDALRasterBandH heights = GDALGetRasterBand(dataset, 1);
  std::vector<std::int16_t> row(tile.cols);
  const auto* next = reinterpret_cast<const unsigned char*>(bytes.data());
  for (int r = 0; r < tile.rows; ++r) {
    for (std::int16_t& height_m : row) {
      height_m = static_cast<std::int16_t>(next[0] << 8 | next[1]);
      next += 2;
    }
    if (GDALRasterIO(heights, GF_Write, 0, r, tile.cols, 1, row.data(), tile.cols, 1, GDT_Int16, 0,
                     0) != CE_None) {
      return Internal("cannot keep the elevation in memory" + errors.Last(""));
    }
  }
  GDALSetRasterNoDataValue(heights, kVoid);
  const double width_deg = 1.0 / (tile.cols - 1), height_deg = 1.0 / (tile.rows - 1);
  double transform[] = {tile.west_deg - 0.5 * width_deg,       width_deg, 0.0,
                        tile.south_deg + 1 + 0.5 * height_deg, 0.0,       -height_deg};
  GDALSetGeoTransform(dataset, transform);
  OGRSpatialReferenceH wgs84 = OSRNewSpatialReference(nullptr);
  if (OSRSetWellKnownGeogCS(wgs84, "WGS84") == OGRERR_NONE) GDALSetSpatialRef(dataset, wgs84);
  OSRDestroySpatialReference(wgs84);
  return Status();
}

Status ElevationRaster::File::CheckBands() {
  const int bands = GDALGetRasterCount(dataset);
  band = GDALGetRasterBand(dataset, 1);
  const bool alpha = bands == 2 && (GDALGetMaskFlags(band) & GMF_ALPHA) != 0;
  if (bands != 1 && !alpha) {
    return InvalidArgument("the elevation has " + std::to_string(bands) +
                           " bands, as pictures have; legal is one band of heights");
  }
  const GDALDataType type = GDALGetRasterDataType(band);
  if (GDALDataTypeIsComplex(type) != 0) {
    return InvalidArgument("the elevation's samples are complex numbers (" +
                           std::string(GDALGetDataTypeName(type)) +
                           "); legal are whole and floating point numbers");
  }
  if (GDALGetRasterColorInterpretation(band) == GCI_PaletteIndex ||
      GDALGetRasterColorTable(band) != nullptr) {
    return InvalidArgument(
        "the elevation's samples are colours of a palette; legal is one band of heights");
  }
  return Status();
}

Status ElevationRaster::File::CheckBlocks() const {
  int cols = 0, rows = 0;
  GDALGetBlockSize(band, &cols, &rows);
  const std::int64_t bytes = std::int64_t{cols} * rows *
                             std::max(GDALGetDataTypeSizeBytes(GDALGetRasterDataType(band)), 1);
  if (cols > 0 && rows > 0 && bytes <= kMaxBlockBytes) return Status();
  return InvalidArgument("the elevation is stored in blocks of " + std::to_string(cols) + " x " +
                         std::to_string(rows) + " samples, " + std::to_string(bytes) +
                         " bytes each; legal are at most " + std::to_string(kMaxBlockBytes) +
                         " bytes: store it in tiles or smaller strips");
}

Status ElevationRaster::File::ReadHeightUnit() {
  const GdalErrors errors;
  std::string unit = GDALGetRasterUnitType(band);
  double metres = 0.0;
  OGRSpatialReferenceH crs = GDALGetSpatialRef(dataset);
  if (unit.empty() && crs != nullptr && OSRIsCompound(crs) != 0) {
    char* unit_name = nullptr;
    metres = OSRGetTargetLinearUnits(crs, "COMPD_CS|VERT_CS", &unit_name);
    unit = unit_name != nullptr ? unit_name : "";
  } else if (const auto known = MetresOf(unit)) {
    metres = *known;
  }
  if (!(metres > 0.0 && std::isfinite(metres))) {
    return InvalidArgument("the elevation's heights are in " + Quote(unit) +
                           "; legal are m, cm, dm, mm, km, ft and US survey foot");
  }
  scale_m = metres * GDALGetRasterScale(band, nullptr);
  offset_m = metres * GDALGetRasterOffset(band, nullptr);
  if (std::isfinite(scale_m) && std::isfinite(offset_m) && scale_m != 0.0) return Status();
  return InvalidArgument("the elevation's scale is " +
                         FormatDouble(GDALGetRasterScale(band, nullptr)) + " and its offset " +
                         FormatDouble(GDALGetRasterOffset(band, nullptr)) +
                         "; legal are finite numbers, and a scale other than 0");
}

Status ElevationRaster::File::ReadReference() {
  const GdalErrors errors;
  // The transform must be there, and give samples a size.
  std::array<double, 6>& t = reference.transform;
  if (GDALGetGeoTransform(dataset, t.data()) != CE_None) {
    return InvalidArgument(
        "the GeoTIFF has no georeference, so nobody knows where its samples lie or how large they "
        "are; legal is one with a coordinate system and a place (gdal_translate -a_srs, -a_ullr); "
        "a picture without one is a height map");
  }
  const double area = t[1] * t[5] - t[2] * t[4];
  bool finite = std::isfinite(area) && area != 0.0;
  for (const double value : t) finite = finite && std::isfinite(value);
  if (!finite) {
    return InvalidArgument(
        "the elevation's georeference is degenerate: its samples have no size (transform " +
        FormatDouble(t[0]) + ", " + FormatDouble(t[1]) + ", " + FormatDouble(t[2]) + ", " +
        FormatDouble(t[3]) + ", " + FormatDouble(t[4]) + ", " + FormatDouble(t[5]) + ")");
  }

  // A coordinate system must be one on the earth; its heights do not matter.
  if (OGRSpatialReferenceH crs = GDALGetSpatialRef(dataset)) {
    OGRSpatialReferenceH flat = OSRClone(crs);
    OSRStripVertical(flat);
    const bool usable = OSRIsGeographic(flat) != 0 || OSRIsProjected(flat) != 0;
    if (usable) reference.crs = WellKnownText(flat);
    const char* crs_name = OSRGetName(crs);
    const std::string shown = Quote(crs_name != nullptr ? crs_name : "");
    OSRDestroySpatialReference(flat);
    if (!reference.crs.empty()) return Status();
    return InvalidArgument("the elevation's coordinate system is " + shown +
                           ", which does not lie on the earth; legal are geographic ones (degrees) "
                           "and projected ones");
  }
  if (format != ElevationFormat::kArcAscii) {
    return InvalidArgument(
        "the GeoTIFF has a place but no coordinate system, so nobody knows what its numbers mean; "
        "legal is one with a coordinate system (gdal_translate -a_srs EPSG:...)");
  }
  // An ASCII grid has its coordinate system in a file of its own, if anywhere.
  const bool judged = coordinates == ElevationUnit::kJudged;
  const GridNumbers grid = {t, GDALGetRasterXSize(dataset), GDALGetRasterYSize(dataset),
                            ascii.height_range_m};
  const bool degrees = judged ? LooksLikeDegrees(grid) : coordinates == ElevationUnit::kDegrees;
  if (judged) warnings.push_back(JudgedWarning(grid, degrees));
  if (!degrees) return Status();
  // Degrees are those of WGS 84.
  if (!LiesOnTheEarth(t, grid.cols, grid.rows)) {
    return InvalidArgument(
        "the elevation is said to be in degrees, but reaches beyond -180 to 360 degrees of "
        "longitude or -90 to 90 of latitude");
  }
  OGRSpatialReferenceH wgs84 = OSRNewSpatialReference(nullptr);
  if (OSRSetWellKnownGeogCS(wgs84, "WGS84") == OGRERR_NONE) reference.crs = WellKnownText(wgs84);
  OSRDestroySpatialReference(wgs84);
  if (reference.crs.empty()) return Internal("PROJ does not know WGS 84" + errors.Last(name));
  return Status();
}

ElevationRaster::ElevationRaster(std::unique_ptr<File> file) : file_(std::move(file)) {}
ElevationRaster::ElevationRaster(ElevationRaster&&) noexcept = default;
ElevationRaster::~ElevationRaster() = default;

Result<ElevationRaster> ElevationRaster::Open(std::string_view bytes, std::string_view name,
                                              ElevationUnit unit) {
  PrepareGdal();
  LW_ASSIGN_OR_RETURN(const ElevationFile recognized, RecognizeElevation(bytes, name));
  auto file = std::make_unique<File>();
  file->coordinates = unit;
  if (recognized.format == ElevationFormat::kArcAscii) {
    LW_ASSIGN_OR_RETURN(file->ascii, NormalizeArcAscii(bytes));
    file->warnings = file->ascii.warnings;
    bytes = file->ascii.text;
  }
  LW_RETURN_IF_ERROR(file->Open(bytes, recognized));
  return ElevationRaster(std::move(file));
}

int ElevationRaster::cols() const { return GDALGetRasterXSize(file_->dataset); }
int ElevationRaster::rows() const { return GDALGetRasterYSize(file_->dataset); }
const GeoReference& ElevationRaster::reference() const { return file_->reference; }
double ElevationRaster::height_step_m() const {
  const GDALDataType type = GDALGetRasterDataType(file_->band);
  const bool whole_numbers = file_->format == ElevationFormat::kArcAscii
                                 ? file_->ascii.whole_numbers
                                 : GDALDataTypeIsFloating(type) == 0;
  return whole_numbers ? std::abs(file_->scale_m) : 0.0;
}
const std::vector<std::string>& ElevationRaster::warnings() const { return file_->warnings; }

namespace {

// Samples and, where the band has one, their mask: 0 is no-data.
class SampleReader {
 public:
  explicit SampleReader(GDALRasterBandH band) : band_(band) {
    if ((GDALGetMaskFlags(band) & GMF_ALL_VALID) == 0) mask_band_ = GDALGetMaskBand(band);
    GDALGetRasterNoDataValue(band, &has_no_data_);
  }

  bool Read(int col, int row, int cols, int rows) {
    const std::size_t count = static_cast<std::size_t>(cols) * rows;
    samples_.resize(count);
    if (GDALRasterIO(band_, GF_Read, col, row, cols, rows, samples_.data(), cols, rows, GDT_Float32,
                     0, 0) != CE_None) {
      return false;
    }
    if (mask_band_ == nullptr) return true;
    mask_.resize(count);
    return GDALRasterIO(mask_band_, GF_Read, col, row, cols, rows, mask_.data(), cols, rows,
                        GDT_Byte, 0, 0) == CE_None;
  }
  // Whether the sample holds something, by what the file says of it.
  bool Holds(std::size_t i) const {
    if (mask_band_ != nullptr && mask_[i] == 0) return false;
    return has_no_data_ != 0 || samples_[i] != kUsualNoData;
  }
  float operator[](std::size_t i) const { return samples_[i]; }

 private:
  GDALRasterBandH band_;
  GDALRasterBandH mask_band_ = nullptr;
  int has_no_data_ = 0;
  std::vector<float> samples_;
  std::vector<std::uint8_t> mask_;
};

}  // namespace

Result<Grid<float>> ElevationRaster::Read(const DataWindow& window) const {
  const GdalErrors errors;
  SampleReader reader(file_->band);
  Grid<float> means(window.rows, window.cols);
  const int width = window.cols * window.block_cols;
  int block_height = 0, block_width = 0;
  GDALGetBlockSize(file_->band, &block_width, &block_height);
  // A chunk has about as many rows as a block of the file, so that few blocks are decoded twice.
  const std::int64_t fitting = std::max<std::int64_t>(kChunkSamples / width, 1);
  const std::int64_t wanted = std::clamp<std::int64_t>(block_height, 1, fitting);
  const int chunk = static_cast<int>(std::max<std::int64_t>(wanted / window.block_rows, 1));

  std::vector<double> sum(window.cols);
  std::vector<int> count(window.cols);
  for (int begin = 0; begin < window.rows; begin += chunk) {
    const int end = std::min(begin + chunk, window.rows);
    if (!reader.Read(window.col, window.row + begin * window.block_rows, width,
                     (end - begin) * window.block_rows)) {
      return InvalidArgument("the elevation's samples cannot be read, it is cut off or damaged" +
                             errors.Last(file_->name));
    }
    std::size_t i = 0;
    for (int r = begin; r < end; ++r) {
      std::fill(sum.begin(), sum.end(), 0.0);
      std::fill(count.begin(), count.end(), 0);
      for (int k = 0; k < window.block_rows; ++k) {
        for (int c = 0; c < window.cols; ++c) {
          for (int j = 0; j < window.block_cols; ++j, ++i) {
            const double height_m = file_->offset_m + file_->scale_m * reader[i];
            // False for NaN.
            const bool ground = height_m >= kLowestGround_m && height_m <= kHighestGround_m;
            if (!ground || !reader.Holds(i)) continue;
            sum[c] += height_m;
            ++count[c];
          }
        }
      }
      for (int c = 0; c < window.cols; ++c) {
        means(r, c) = count[c] > 0 ? static_cast<float>(sum[c] / count[c])
                                   : std::numeric_limits<float>::quiet_NaN();
      }
    }
  }
  return means;
}

}  // namespace latticeworld::internal
