#ifndef LATTICEWORLD_RELIEF_ELEVATION_ELEVATION_H_
#define LATTICEWORLD_RELIEF_ELEVATION_ELEVATION_H_

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/result.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {

// What the coordinates of data without a coordinate system are.
enum class ElevationUnit : std::uint8_t { kJudged, kDegrees, kMetres };

constexpr std::array<EnumName<ElevationUnit>, 3> EnumNames(ElevationUnit) {
  return {{{ElevationUnit::kJudged, ""},
           {ElevationUnit::kDegrees, "degrees"},
           {ElevationUnit::kMetres, "metres"}}};
}

// Which piece of real land, and how high it stands in the world.
struct ElevationOptions {
  double size_m = 512.0;       // side of the square that is cut out
  double resolution_m = 0.5;   // of the world: the relief is no finer than this and no finer than
                               // the data carries
  bool centered = true;        // cut out around the middle of the data, else around:
  double latitude_deg = 0.0;   // WGS 84, [-90, 90]
  double longitude_deg = 0.0;  // [-180, 180]
  bool keep_altitude = false;  // true: heights as in the file; false: the lowest becomes 0
  ElevationUnit unit = ElevationUnit::kJudged;  // of an ASCII grid, by its numbers unless said
};
std::vector<Violation> Validate(const ElevationOptions& options);

// Reads real elevation through GDAL: GeoTIFF, SRTM .hgt (its name says where it lies), Arc/Info
// ASCII grid. True metres: data in degrees is projected to metres around the place that is asked
// for; heights in other units are converted; no-data, NaN and infinity are filled from around
// them. The relief's geo says where the world's origin lies. name: the file's own, for formats
// that need it. Errors: INVALID_ARGUMENT saying what was given and what is legal (not elevation; no
// georeference; smaller than the world; nothing but no-data; the place lies outside).
Result<Relief> ReadElevation(std::string_view bytes, std::string_view name,
                             const ElevationOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RELIEF_ELEVATION_ELEVATION_H_
