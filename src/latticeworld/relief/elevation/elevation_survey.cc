#include "latticeworld/relief/elevation/elevation_survey.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/geomorphology/resample.h"
#include "latticeworld/relief/elevation/elevation_fill.h"
#include "latticeworld/relief/elevation/elevation_frame.h"
#include "latticeworld/relief/elevation/elevation_raster.h"

namespace latticeworld {
namespace {

using internal::DataWindow;
using internal::ElevationFrame;
using internal::ElevationRaster;

constexpr int kMaxSide = 8192;

// The same on another grid over the same area: of each cell, that of the one at its centre.
Grid<unsigned char> Stretched(const Grid<unsigned char>& mask, int rows, int cols) {
  Grid<unsigned char> stretched(rows, cols);
  for (int r = 0; r < rows; ++r) {
    const int from = static_cast<int>((r + 0.5) / rows * mask.rows());
    for (int c = 0; c < cols; ++c) {
      stretched(r, c) = mask(from, static_cast<int>((c + 0.5) / cols * mask.cols()));
    }
  }
  return stretched;
}

}  // namespace

Result<ElevationSurvey> SurveyElevation(std::string_view bytes, std::string_view name,
                                        ElevationUnit unit) {
  LW_ASSIGN_OR_RETURN(const ElevationRaster raster, ElevationRaster::Open(bytes, name, unit));
  LW_ASSIGN_OR_RETURN(const ElevationFrame frame, ElevationFrame::Create(raster, {}));
  DataWindow window;
  window.block_cols = window.block_rows =
      (std::max(raster.cols(), raster.rows()) + kMaxSide - 1) / kMaxSide;
  window.cols = raster.cols() / window.block_cols;
  window.rows = raster.rows() / window.block_rows;
  ElevationSurvey survey;
  LW_ASSIGN_OR_RETURN(survey.height_m, raster.Read(window));
  survey.missing = Grid<unsigned char>(window.rows, window.cols);
  std::transform(survey.height_m.begin(), survey.height_m.end(), survey.missing.begin(),
                 [](float height) { return std::isnan(height) ? 1 : 0; });
  if (internal::FillVoids(&survey.height_m) == 1.0) {
    return InvalidArgument(
        "the elevation holds nothing but no-data; legal is land with at least one height");
  }
  const double width_m = frame.sample_width_m() * window.block_cols;
  const double height_m = frame.sample_height_m() * window.block_rows;
  survey.resolution_m = std::min(width_m, height_m);
  const int rows = static_cast<int>(std::lround(window.rows * height_m / survey.resolution_m));
  const int cols = static_cast<int>(std::lround(window.cols * width_m / survey.resolution_m));
  if (rows != window.rows || cols != window.cols) {
    survey.height_m = Resample(survey.height_m, rows, cols);
    survey.missing = Stretched(survey.missing, rows, cols);
  }
  survey.warnings = raster.warnings();
  return survey;
}

}  // namespace latticeworld
