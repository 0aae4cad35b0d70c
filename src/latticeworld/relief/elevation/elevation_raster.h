#ifndef LATTICEWORLD_RELIEF_ELEVATION_ELEVATION_RASTER_H_
#define LATTICEWORLD_RELIEF_ELEVATION_ELEVATION_RASTER_H_

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/relief/elevation/elevation.h"

namespace latticeworld::internal {

// Says where samples lie: x = t[0] + t[1] col + t[2] row, y = t[3] + t[4] col + t[5] row in the
// coordinates of crs; (0, 0) is the outer corner of the first sample.
struct GeoReference {
  std::array<double, 6> transform{};
  std::string crs;  // well-known text; "": metres that lie nowhere on the earth
};

// A part of the samples; whole blocks of them become one value each.
struct DataWindow {
  int col = 0;
  int row = 0;
  int cols = 0;        // means a row
  int rows = 0;        // rows of means
  int block_cols = 1;  // samples a mean
  int block_rows = 1;
};

// Samples of elevation, through GDAL.
class ElevationRaster {
 public:
  // bytes: outlive the raster. unit: of an ASCII grid, which names no coordinate system; judged by
  // its place, cells and heights unless said. Errors: INVALID_ARGUMENT saying what was given and
  // what is legal.
  static Result<ElevationRaster> Open(std::string_view bytes, std::string_view name,
                                      ElevationUnit unit = ElevationUnit::kJudged);
  ElevationRaster(ElevationRaster&&) noexcept;
  ElevationRaster& operator=(ElevationRaster&&) = delete;
  ~ElevationRaster();

  int cols() const;
  int rows() const;
  const GeoReference& reference() const;
  // Returns the step between neighbouring heights if they are whole numbers in the file [m]; 0:
  // they are floating-point numbers.
  double height_step_m() const;
  // What had to be guessed.
  const std::vector<std::string>& warnings() const;

  // Mean heights [m] of the window's blocks, NaN where a block has no sample: no-data, NaN,
  // infinity, or no height on the earth. The window lies inside the data. Errors:
  // INVALID_ARGUMENT (damaged, cut off).
  Result<Grid<float>> Read(const DataWindow& window) const;

 private:
  struct File;
  explicit ElevationRaster(std::unique_ptr<File> file);

  std::unique_ptr<File> file_;
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_ELEVATION_ELEVATION_RASTER_H_
