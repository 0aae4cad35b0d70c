#include "latticeworld/relief/elevation/elevation_frame.h"

#include <gdal.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <type_traits>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/relief/elevation/gdal_errors.h"

namespace latticeworld::internal {
namespace {

// A world may reach half a sample beyond the data: projections differ by that much from the metres
// that a file's name promises.
constexpr double kTolerance_samples = 0.5;
constexpr double kLatticeError_samples = 0.01;
constexpr int kCoarsestNodes = 17;
constexpr int kFinestNodes = 1025;

struct DestroyCrs {
  void operator()(OGRSpatialReferenceH crs) const { OSRDestroySpatialReference(crs); }
};
struct DestroyTransformation {
  void operator()(OGRCoordinateTransformationH t) const { OCTDestroyCoordinateTransformation(t); }
};
using Crs = std::unique_ptr<std::remove_pointer_t<OGRSpatialReferenceH>, DestroyCrs>;
using Transformation =
    std::unique_ptr<std::remove_pointer_t<OGRCoordinateTransformationH>, DestroyTransformation>;

struct Coordinates {
  double x = 0.0;
  double y = 0.0;
};

// x is east or longitude, whatever order the authority gives.
Crs MakeCrs(const std::string& definition) {
  Crs crs(OSRNewSpatialReference(nullptr));
  if (OSRSetFromUserInput(crs.get(), definition.c_str()) != OGRERR_NONE) return nullptr;
  OSRSetAxisMappingStrategy(crs.get(), OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

Transformation MakeTransformation(const Crs& from, const Crs& to) {
  if (from == nullptr || to == nullptr) return nullptr;
  return Transformation(OCTNewCoordinateTransformation(from.get(), to.get()));
}

std::optional<Coordinates> Apply(const Transformation& transformation, Coordinates point) {
  int success = 0;
  OCTTransformEx(transformation.get(), 1, &point.x, &point.y, nullptr, &success);
  if (success == 0 || !std::isfinite(point.x) || !std::isfinite(point.y)) return std::nullopt;
  return point;
}

std::string Degrees(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof(buffer), "%.5f", value);
  return buffer;
}
std::string Plain(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof(buffer), "%.10g", value);
  return buffer;
}
std::string Metres(double value_m) {
  const double decimals = value_m < 100.0 ? 10.0 : 1.0;
  return Plain(std::floor(value_m * decimals) / decimals) + " m";
}

}  // namespace

struct ElevationFrame::Mapping {
  int cols = 0;
  int rows = 0;
  std::array<double, 6> forward{};  // samples to coordinates of the data
  std::array<double, 6> inverse{};
  bool degrees = false;               // the coordinates of the data are longitude and latitude
  bool centered = true;               // the origin is the middle of the data
  Transformation from_map;            // frame map to the data's coordinates; null: only a shift
  Coordinates origin;                 // in the data's coordinates
  std::optional<Coordinates> middle;  // longitude and latitude of the middle of the data
  std::optional<GeoOrigin> geo;
  double sample_width_m = 0.0;
  double sample_height_m = 0.0;

  Coordinates DataCoordinates(DataPoint p) const {
    return {forward[0] + forward[1] * p.col + forward[2] * p.row,
            forward[3] + forward[4] * p.col + forward[5] * p.row};
  }
  DataPoint FromDataCoordinates(Coordinates c) const {
    if (degrees) {
      // The data may count 0 to 360 degrees, and PROJ answers -180 to 180.
      const double middle_x = DataCoordinates({0.5 * cols, 0.5 * rows}).x;
      c.x -= 360.0 * std::round((c.x - middle_x) / 360.0);
    }
    return {inverse[0] + inverse[1] * c.x + inverse[2] * c.y,
            inverse[3] + inverse[4] * c.x + inverse[5] * c.y};
  }
  std::optional<DataPoint> PointAt(double x_m, double y_m) const {
    if (from_map == nullptr) return FromDataCoordinates({origin.x + x_m, origin.y + y_m});
    const auto coordinates = Apply(from_map, {x_m, y_m});
    if (!coordinates) return std::nullopt;
    return FromDataCoordinates(*coordinates);
  }
  bool Inside(DataPoint p, double tolerance_samples) const {
    return p.col >= -tolerance_samples && p.col <= cols + tolerance_samples &&
           p.row >= -tolerance_samples && p.row <= rows + tolerance_samples;
  }

  Status FindOrigin(const ElevationRaster& raster, const ElevationOptions& options);
  Status FindSampleSize();
  bool Fits(double size_m, double tolerance_samples) const;
  double LargestSize_m(double not_fitting_m) const;
  std::string Extent() const;
  std::optional<PlaceLattice> LatticeOf(double size_m, int nodes) const;
  double ErrorOf(const PlaceLattice& lattice, double size_m) const;
};

Status ElevationFrame::Mapping::FindOrigin(const ElevationRaster& raster,
                                           const ElevationOptions& options) {
  const GdalErrors errors;
  // Data without a coordinate system have no place but their middle.
  origin = DataCoordinates({0.5 * cols, 0.5 * rows});
  if (raster.reference().crs.empty()) {
    if (options.centered) return Status();
    return InvalidArgument(
        "a place is asked for, but the elevation has no coordinate system, so nobody knows where "
        "it lies; legal is the middle of the data");
  }
  // Else places are related to WGS 84.
  const Crs data_crs = MakeCrs(raster.reference().crs);
  const Crs wgs84 = MakeCrs("+proj=longlat +datum=WGS84 +no_defs");
  const Transformation to_wgs84 = MakeTransformation(data_crs, wgs84);
  const Transformation from_wgs84 = MakeTransformation(wgs84, data_crs);
  const Status unknown_system = InvalidArgument(
      "the elevation's coordinate system cannot be related to WGS 84" + errors.Last(""));
  if (to_wgs84 == nullptr || from_wgs84 == nullptr) return unknown_system;
  degrees = OSRIsGeographic(data_crs.get()) != 0;

  middle = Apply(to_wgs84, origin);
  if (!middle || std::abs(middle->y) > 90.0) return unknown_system;
  // The place asked for becomes the origin, or the middle of the data does.
  Coordinates place{options.longitude_deg, options.latitude_deg};
  if (options.centered) {
    place = *middle;
  } else {
    const auto coordinates = Apply(from_wgs84, place);
    const auto point =
        coordinates ? std::optional<DataPoint>(FromDataCoordinates(*coordinates)) : std::nullopt;
    if (!point || !Inside(*point, 0.0)) {
      return InvalidArgument("latitude " + Degrees(place.y) + ", longitude " + Degrees(place.x) +
                             " lies outside the elevation, which " + Extent());
    }
    origin = *coordinates;
  }
  geo = GeoOrigin{place.y, place.x - 360.0 * std::round(place.x / 360.0), 0.0};
  // Distances and directions from the origin are true in its own azimuthal projection.
  char local[160];
  std::snprintf(local, sizeof(local),
                "+proj=aeqd +lat_0=%.12f +lon_0=%.12f +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs",
                geo->latitude_deg, geo->longitude_deg);
  from_map = MakeTransformation(MakeCrs(local), data_crs);
  return from_map != nullptr ? Status() : unknown_system;
}

Status ElevationFrame::Mapping::FindSampleSize() {
  constexpr double kStep_m = 1.0;
  const auto east = PointAt(kStep_m, 0.0), west = PointAt(-kStep_m, 0.0);
  const auto north = PointAt(0.0, kStep_m), south = PointAt(0.0, -kStep_m);
  if (east && west && north && south) {
    const double dc_dx = (east->col - west->col) / (2.0 * kStep_m);
    const double dr_dx = (east->row - west->row) / (2.0 * kStep_m);
    const double dc_dy = (north->col - south->col) / (2.0 * kStep_m);
    const double dr_dy = (north->row - south->row) / (2.0 * kStep_m);
    const double determinant = dc_dx * dr_dy - dc_dy * dr_dx;
    sample_width_m = std::hypot(dr_dx, dr_dy) / std::abs(determinant);
    sample_height_m = std::hypot(dc_dx, dc_dy) / std::abs(determinant);
  }
  const auto legal = [](double side_m) { return side_m > 1e-4 && side_m < 1e6; };
  if (legal(sample_width_m) && legal(sample_height_m)) return Status();
  return InvalidArgument("the elevation's samples are " + FormatDouble(sample_width_m) + " m x " +
                         FormatDouble(sample_height_m) +
                         " m large; its georeference or coordinate system is wrong");
}

bool ElevationFrame::Mapping::Fits(double size_m, double tolerance_samples) const {
  constexpr int kSteps = 8;
  const double half_m = 0.5 * size_m;
  for (int i = 0; i <= kSteps; ++i) {
    const double along_m = -half_m + size_m * i / kSteps;
    for (const Coordinates c : {Coordinates{along_m, half_m}, Coordinates{along_m, -half_m},
                                Coordinates{half_m, along_m}, Coordinates{-half_m, along_m}}) {
      const auto point = PointAt(c.x, c.y);
      if (!point || !Inside(*point, tolerance_samples)) return false;
    }
  }
  return true;
}

double ElevationFrame::Mapping::LargestSize_m(double not_fitting_m) const {
  double low_m = 0.0, high_m = not_fitting_m;
  for (int i = 0; i < 40; ++i) {
    const double middle_m = 0.5 * (low_m + high_m);
    (Fits(middle_m, 0.0) ? low_m : high_m) = middle_m;
  }
  return low_m;
}

// "spans 105 x 77 samples, ..., latitude 40.0 to 41.0, longitude ..."
std::string ElevationFrame::Mapping::Extent() const {
  double low_x = INFINITY, high_x = -INFINITY, low_y = INFINITY, high_y = -INFINITY;
  for (const DataPoint corner : {DataPoint{0, 0}, DataPoint{1.0 * cols, 0},
                                 DataPoint{0, 1.0 * rows}, DataPoint{1.0 * cols, 1.0 * rows}}) {
    const Coordinates c = DataCoordinates(corner);
    low_x = std::min(low_x, c.x), high_x = std::max(high_x, c.x);
    low_y = std::min(low_y, c.y), high_y = std::max(high_y, c.y);
  }
  const std::string samples = std::to_string(cols) + " x " + std::to_string(rows) + " samples";
  if (degrees) {
    return "spans " + samples + ", latitude " + Degrees(low_y) + " to " + Degrees(high_y) +
           " and longitude " + Degrees(low_x) + " to " + Degrees(high_x);
  }
  return "spans " + samples + ", x " + Plain(low_x) + " to " + Plain(high_x) + " and y " +
         Plain(low_y) + " to " + Plain(high_y) + " in its own coordinates" +
         (middle ? ", its middle at latitude " + Degrees(middle->y) + ", longitude " +
                       Degrees(middle->x)
                 : "");
}

std::optional<PlaceLattice> ElevationFrame::Mapping::LatticeOf(double size_m, int nodes) const {
  PlaceLattice lattice;
  lattice.nodes = nodes;
  lattice.points.reserve(static_cast<std::size_t>(nodes) * nodes);
  for (int r = 0; r < nodes; ++r) {
    for (int c = 0; c < nodes; ++c) {
      const auto point =
          PointAt(size_m * (c / (nodes - 1.0) - 0.5), size_m * (0.5 - r / (nodes - 1.0)));
      if (!point) return std::nullopt;
      lattice.points.push_back(*point);
    }
  }
  return lattice;
}

// How far the middles of the lattice's cells are off [samples].
double ElevationFrame::Mapping::ErrorOf(const PlaceLattice& lattice, double size_m) const {
  const int nodes = lattice.nodes;
  const double cell_m = size_m / (nodes - 1);
  double largest = 0.0;
  // Every 16th of the coarsest lattice's cells, whatever the lattice.
  const int step = std::max(1, (nodes - 1) / (kCoarsestNodes - 1));
  for (int r = 0; r + 1 < nodes; r += step) {
    for (int c = 0; c + 1 < nodes; c += step) {
      const DataPoint* p = &lattice.points[static_cast<std::size_t>(r) * nodes + c];
      const auto exact =
          PointAt(-0.5 * size_m + (c + 0.5) * cell_m, 0.5 * size_m - (r + 0.5) * cell_m);
      if (!exact) return INFINITY;
      const double col = 0.25 * (p[0].col + p[1].col + p[nodes].col + p[nodes + 1].col);
      const double row = 0.25 * (p[0].row + p[1].row + p[nodes].row + p[nodes + 1].row);
      largest = std::max({largest, std::abs(col - exact->col), std::abs(row - exact->row)});
    }
  }
  return largest;
}

ElevationFrame::ElevationFrame(std::unique_ptr<Mapping> mapping) : mapping_(std::move(mapping)) {}
ElevationFrame::ElevationFrame(ElevationFrame&&) noexcept = default;
ElevationFrame::~ElevationFrame() = default;

Result<ElevationFrame> ElevationFrame::Create(const ElevationRaster& raster,
                                              const ElevationOptions& options) {
  auto mapping = std::make_unique<Mapping>();
  mapping->cols = raster.cols();
  mapping->rows = raster.rows();
  mapping->centered = options.centered;
  mapping->forward = raster.reference().transform;
  if (GDALInvGeoTransform(mapping->forward.data(), mapping->inverse.data()) == 0) {
    return InvalidArgument("the elevation's georeference is degenerate: its samples have no size");
  }
  LW_RETURN_IF_ERROR(mapping->FindOrigin(raster, options));
  const GdalErrors errors;
  LW_RETURN_IF_ERROR(mapping->FindSampleSize());
  return ElevationFrame(std::move(mapping));
}

const std::optional<GeoOrigin>& ElevationFrame::geo() const { return mapping_->geo; }
double ElevationFrame::sample_width_m() const { return mapping_->sample_width_m; }
double ElevationFrame::sample_height_m() const { return mapping_->sample_height_m; }

Result<PlaceLattice> ElevationFrame::Lattice(double size_m) const {
  const GdalErrors errors;
  if (!mapping_->Fits(size_m, kTolerance_samples)) {
    const double largest_m = mapping_->LargestSize_m(size_m);
    return InvalidArgument("a world of " + FormatDouble(size_m) + " m around " +
                           (mapping_->centered ? "the middle of the elevation" : "that place") +
                           " reaches beyond the data, which " + mapping_->Extent() + ", about " +
                           Metres(mapping_->cols * mapping_->sample_width_m) + " x " +
                           Metres(mapping_->rows * mapping_->sample_height_m) +
                           "; legal is a size of at most " + Metres(largest_m) + " there");
  }
  for (int nodes = kCoarsestNodes; nodes <= kFinestNodes; nodes = 2 * nodes - 1) {
    auto lattice = mapping_->LatticeOf(size_m, nodes);
    if (lattice && mapping_->ErrorOf(*lattice, size_m) < kLatticeError_samples) {
      return *std::move(lattice);
    }
  }
  return InvalidArgument(
      "the elevation's coordinate system is too uneven there to be laid over a world (a pole, or "
      "the edge of a projection)");
}

}  // namespace latticeworld::internal
