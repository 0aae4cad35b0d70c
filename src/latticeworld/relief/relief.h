#ifndef LATTICEWORLD_RELIEF_RELIEF_H_
#define LATTICEWORLD_RELIEF_RELIEF_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/geo_origin.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

inline constexpr int kReliefSummarySize = 32;  // cells a side, as the symbolic layout
inline constexpr int kMinReliefSize = 33;      // samples a side of a height map
inline constexpr int kMaxReliefSize = 8193;

// v_L, read: the shape of the land that the user gave. It spans the whole world whatever its size.
struct Relief {
  Grid<float> height_m;  // (rows x cols), square but for what is only measured; row 0 north
  Grid<float> summary;   // (32 x 32) mean height, scaled so that the lowest is 0 and the highest 1
  std::string caption;   // "high ground in the upper right falling to low ground in the lower left"
  double height_step_m = 0.0;         // between neighbouring values of the picture; 0: not in steps
  std::optional<GeoOrigin> geo;       // of real land
  std::vector<std::string> warnings;  // what was guessed or made up while it was read
};

// Height [m] = offset + scale * value / largest value of the picture's depth (255 or 65535; of a
// PGM its own maxval).
struct HeightMapOptions {
  double height_scale_m = 100.0;  // [0, 9000]: from the lowest to the highest possible value
  double height_offset_m = 0.0;   // [-9000, 9000]
};
std::vector<Violation> Validate(const HeightMapOptions& options);

// Reads an 8- or 16-bit greyscale height map (colour is refused) from the bytes of a PNG, PGM or
// TIFF. If the picture is not square, its middle square is taken, and a warning says which pixels
// are kept. Errors: INVALID_ARGUMENT (not such a picture, truncated, a side outside 33..8193,
// options). The header is checked before pixels are decoded, so that a hostile size costs no
// memory.
Result<Relief> ReadHeightMap(std::string_view bytes, const HeightMapOptions& options);
// The same with nothing cut off, (rows x cols) of the picture: for measuring.
Result<Relief> ReadWholeHeightMap(std::string_view bytes, const HeightMapOptions& options);

// Relief from height samples: summary and caption are made. height_m: finite, at least 33 a side.
Relief MakeRelief(Grid<float> height_m, double height_step_m = 0.0);

// Gentle rolling land from 0 to amplitude_m for fixed-height scenes. Its hills are nearly half the
// world wide. The same seed and size give the same land at every resolution.
Grid<float> ProceduralRelief(const GridGeometry& geometry, double amplitude_m, std::uint64_t seed);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RELIEF_RELIEF_H_
