#ifndef LATTICEWORLD_TOOLS_LAND_READING_H_
#define LATTICEWORLD_TOOLS_LAND_READING_H_

#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/relief/elevation/elevation.h"

namespace latticeworld::tools {

// A piece of land from wherever it comes.
struct Land {
  std::string path;
  Grid<float> height_m;       // of the water's surface where there is water
  Grid<unsigned char> water;  // 1: water, or nobody knows the height
  double resolution_m = 0.0;
  std::vector<std::string> warnings;
};

struct LandOptions {
  double size_m = 0.0;                                    // width of a height map; 0: not given
  double height_scale_m = 100.0;                          // of a height map, from black to white
  ElevationUnit elevation_unit = ElevationUnit::kJudged;  // of an ASCII grid
};

// Reads a bundle (a directory), a height map (PNG, PGM; TIFF when a size is given) or elevation
// (GeoTIFF, SRTM .hgt, Arc/Info ASCII). Errors: INVALID_ARGUMENT (no such content, smaller than 64
// x 64 cells, a height map without size), NOT_FOUND, those of LoadBundle.
Result<Land> ReadLand(const std::string& path, const LandOptions& options);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_LAND_READING_H_
