#include "latticeworld/relief/elevation/elevation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "latticeworld/common/parallel.h"
#include "latticeworld/common/range.h"
#include "latticeworld/common/text.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/relief/elevation/elevation_fill.h"
#include "latticeworld/relief/elevation/elevation_frame.h"
#include "latticeworld/relief/elevation/elevation_raster.h"

namespace latticeworld {
namespace {

using internal::DataPoint;
using internal::DataWindow;
using internal::ElevationFrame;
using internal::ElevationRaster;
using internal::PlaceLattice;

constexpr std::size_t kMaxBytes = std::size_t{512} << 20;
constexpr int kMaxWindowSide = 32768;  // samples of the data that a world may lie on
// Samples of the relief between two of the data, so that later interpolation by others does not
// flatten what lies between the data's samples.
constexpr double kOversampling = 2.0;
constexpr int kMargin = 16;  // samples around the world that interpolation and filling look at

// Samples a side of the relief.
int SamplesFor(const ElevationOptions& options, const ElevationFrame& frame) {
  const double data_m = std::min(frame.sample_width_m(), frame.sample_height_m());
  const double spacing_m = std::max(options.resolution_m, data_m / kOversampling);
  const double samples = std::ceil(options.size_m / spacing_m - 1e-6);
  return static_cast<int>(std::clamp<double>(samples, kMinReliefSize, kMaxReliefSize));
}

// The samples of the data below the world and around it, taken together in blocks where the world
// is coarser than the data.
Result<DataWindow> WindowFor(const PlaceLattice& lattice, const ElevationFrame& frame,
                             double spacing_m, int cols, int rows) {
  const auto block_of = [spacing_m](double sample_m) {
    return std::max(1, static_cast<int>(std::lround(std::min(spacing_m / sample_m, 1e6))));
  };
  DataWindow window;
  window.block_cols = block_of(frame.sample_width_m());
  window.block_rows = block_of(frame.sample_height_m());
  const auto by_col = [](DataPoint a, DataPoint b) { return a.col < b.col; };
  const auto by_row = [](DataPoint a, DataPoint b) { return a.row < b.row; };
  const auto& points = lattice.points;
  const auto [west, east] = std::minmax_element(points.begin(), points.end(), by_col);
  const auto [north, south] = std::minmax_element(points.begin(), points.end(), by_row);
  const auto span = [](double low, double high, int block, int size, int* begin, int* count) {
    const int margin = kMargin * block;
    *begin = std::max(0, static_cast<int>(std::floor(low)) - margin);
    const int end = std::min(size, static_cast<int>(std::ceil(high)) + margin);
    *count = (end - *begin) / block;
  };
  span(west->col, east->col, window.block_cols, cols, &window.col, &window.cols);
  span(north->row, south->row, window.block_rows, rows, &window.row, &window.rows);
  if (window.cols * window.block_cols > kMaxWindowSide ||
      window.rows * window.block_rows > kMaxWindowSide) {
    return InvalidArgument("the world lies on " + std::to_string(window.cols * window.block_cols) +
                           " x " + std::to_string(window.rows * window.block_rows) +
                           " samples of the elevation; legal are at most " +
                           std::to_string(kMaxWindowSide) +
                           " a side: make a coarser file, or ask for a smaller size");
  }
  if (window.cols < 2 || window.rows < 2) {
    return InvalidArgument(
        "the elevation has only " + std::to_string(cols) + " x " + std::to_string(rows) +
        " samples of " + FormatDouble(frame.sample_width_m()) + " m x " +
        FormatDouble(frame.sample_height_m()) + " m, too few for the resolution that is asked for");
  }
  return window;
}

// Adds a border around the grid, so that what lies up to `border` samples beyond the outermost ones
// goes on as it was: a plane stays a plane.
Grid<float> WithBorder(const Grid<float>& values, int border) {
  const int rows = values.rows(), cols = values.cols();
  Grid<float> wide(rows + 2 * border, cols + 2 * border);
  for (int r = 0; r < rows; ++r) {
    float* target = wide.row(r + border);
    std::copy_n(values.row(r), cols, target + border);
    for (int k = 1; k <= border; ++k) {
      target[border - k] = (1 + k) * target[border] - k * target[border + 1];
      float* last = target + border + cols - 1;
      last[k] = (1 + k) * last[0] - k * last[-1];
    }
  }
  for (int k = 1; k <= border; ++k) {
    for (int c = 0; c < wide.cols(); ++c) {
      wide(border - k, c) = (1 + k) * wide(border, c) - k * wide(border + 1, c);
      const int last = border + rows - 1;
      wide(last + k, c) = (1 + k) * wide(last, c) - k * wide(last - 1, c);
    }
  }
  return wide;
}

// Catmull-Rom's four weights, t in [0, 1] from the second sample to the third (Keys 1981).
std::array<float, 4> CubicWeights(float t) {
  const float t2 = t * t, t3 = t2 * t;
  return {0.5f * (-t3 + 2.0f * t2 - t), 0.5f * (3.0f * t3 - 5.0f * t2 + 2.0f),
          0.5f * (-3.0f * t3 + 4.0f * t2 + t), 0.5f * (t3 - t2)};
}

// Looks heights up among the means of a window.
class Surface {
 public:
  Surface(const Grid<float>& means, const DataWindow& window)
      : window_(window), values_(WithBorder(means, kBorder)) {}

  float At(DataPoint point) const {
    const double col = Clamped((point.col - window_.col) / window_.block_cols, values_.cols());
    const double row = Clamped((point.row - window_.row) / window_.block_rows, values_.rows());
    const int c = static_cast<int>(col), r = static_cast<int>(row);
    const auto across = CubicWeights(static_cast<float>(col - c));
    const auto down = CubicWeights(static_cast<float>(row - r));
    float height_m = 0.0f;
    for (int i = 0; i < 4; ++i) {
      const float* v = values_.row(r - 1 + i) + (c - 1);
      height_m +=
          down[i] * (across[0] * v[0] + across[1] * v[1] + across[2] * v[2] + across[3] * v[3]);
    }
    return height_m;
  }

 private:
  static constexpr int kBorder = 3;
  // Returns the place in samples of values_, clamped so that the four samples around it exist.
  static double Clamped(double place, int size) {
    return std::clamp(place - 0.5 + kBorder, 1.0, size - 2.0 - 1e-6);
  }

  const DataWindow window_;
  const Grid<float> values_;
};

// The lattice's points along one row of the relief: y from 0 (north edge) to 1.
void InterpolateRow(const PlaceLattice& lattice, double y, std::vector<DataPoint>* row) {
  const double place = y * (lattice.nodes - 1);
  const int r = std::min(static_cast<int>(place), lattice.nodes - 2);
  const double t = place - r;
  const DataPoint* upper = &lattice.points[static_cast<std::size_t>(r) * lattice.nodes];
  const DataPoint* lower = upper + lattice.nodes;
  for (int i = 0; i < lattice.nodes; ++i) {
    (*row)[i] = {upper[i].col + t * (lower[i].col - upper[i].col),
                 upper[i].row + t * (lower[i].row - upper[i].row)};
  }
}

Grid<float> Sample(const Surface& surface, const PlaceLattice& lattice, int samples) {
  Grid<float> height_m(samples, samples);
  ParallelFor(samples, 0, [&](int begin, int end) {
    std::vector<DataPoint> row(lattice.nodes);
    for (int r = begin; r < end; ++r) {
      InterpolateRow(lattice, (r + 0.5) / samples, &row);
      float* target = height_m.row(r);
      for (int c = 0; c < samples; ++c) {
        const double place = (c + 0.5) / samples * (lattice.nodes - 1);
        const int i = std::min(static_cast<int>(place), lattice.nodes - 2);
        const double t = place - i;
        target[c] = surface.At({row[i].col + t * (row[i + 1].col - row[i].col),
                                row[i].row + t * (row[i + 1].row - row[i].row)});
      }
    }
  });
  return height_m;
}

}  // namespace

std::vector<Violation> Validate(const ElevationOptions& options) {
  std::vector<Violation> violations;
  CheckRange("size", options.size_m, {kMinSize_m, kMaxSize_m}, " m", &violations);
  CheckRange("resolution", options.resolution_m, {kMinResolution_m, kMaxResolution_m}, " m",
             &violations);
  if (options.centered) return violations;
  CheckRange("latitude", options.latitude_deg, {-90.0, 90.0}, " degrees", &violations);
  CheckRange("longitude", options.longitude_deg, {-180.0, 180.0}, " degrees", &violations);
  return violations;
}

namespace {

// Errors: as ReadElevation.
Result<Relief> CutOutOf(const ElevationRaster& raster, const ElevationOptions& options) {
  LW_ASSIGN_OR_RETURN(const ElevationFrame frame, ElevationFrame::Create(raster, options));
  LW_ASSIGN_OR_RETURN(const PlaceLattice lattice, frame.Lattice(options.size_m));
  const int samples = SamplesFor(options, frame);
  LW_ASSIGN_OR_RETURN(const DataWindow window, WindowFor(lattice, frame, options.size_m / samples,
                                                         raster.cols(), raster.rows()));
  LW_ASSIGN_OR_RETURN(Grid<float> means, raster.Read(window));
  const double filled = internal::FillVoids(&means);
  if (filled == 1.0) {
    return InvalidArgument(
        "the elevation holds nothing but no-data where the world would lie; legal is land with at "
        "least one height");
  }
  Grid<float> height_m = Sample(Surface(means, window), lattice, samples);
  std::optional<GeoOrigin> geo = frame.geo();
  if (!options.keep_altitude) {
    const float lowest_m = *std::min_element(height_m.begin(), height_m.end());
    for (float& height : height_m) height -= lowest_m;
    if (geo) geo->altitude_m = lowest_m;
  }
  // Means of several samples lie between the steps.
  const bool steps = window.block_cols == 1 && window.block_rows == 1;
  Relief relief = MakeRelief(std::move(height_m), steps ? raster.height_step_m() : 0.0);
  relief.geo = geo;
  relief.warnings = raster.warnings();
  if (filled > 0.0) {
    relief.warnings.push_back(FormatDouble(std::max(0.1, std::round(1000.0 * filled) / 10.0)) +
                              " % of the elevation was no-data and is filled from around it");
  }
  return relief;
}

}  // namespace

Result<Relief> ReadElevation(std::string_view bytes, std::string_view name,
                             const ElevationOptions& options) {
  LW_RETURN_IF_ERROR(Status::FromViolations("illegal elevation options", Validate(options)));
  if (bytes.size() > kMaxBytes) {
    return InvalidArgument("the elevation takes " + std::to_string(bytes.size()) +
                           " bytes; legal are at most " + std::to_string(kMaxBytes));
  }
  LW_ASSIGN_OR_RETURN(const ElevationRaster raster,
                      ElevationRaster::Open(bytes, name, options.unit));
  Result<Relief> relief = CutOutOf(raster, options);
  if (relief.ok() || raster.warnings().empty()) return relief;
  // What was guessed may be why.
  const Status& refusal = relief.status();
  return Status(refusal.code(), refusal.message() + "; " + Join(raster.warnings(), "; "),
                refusal.violations());
}

}  // namespace latticeworld
