#include "latticeworld/exporting/map_server.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

constexpr double kFreeThreshold = 0.1;
constexpr double kOccupiedThreshold = 0.9;
constexpr int kUnknown = -1;

// map_server, mode scale: p = (255 - grey) / 255 is free below the free threshold, occupied above
// the other, and between them floor(1 + 98 * share). The middle of a value's range is chosen.
unsigned char GreyOfScaled(int occupancy) {
  if (occupancy == 0) return 254;
  if (occupancy == 100) return 0;
  const double share = (std::min(occupancy, 98) - 0.5) / 98.0;
  const double p = kFreeThreshold + share * (kOccupiedThreshold - kFreeThreshold);
  return static_cast<unsigned char>(std::lround(255.0 * (1.0 - p)));
}

// mode raw: the byte is the value.
unsigned char GreyOfRaw(int occupancy) { return static_cast<unsigned char>(occupancy); }

}  // namespace

Result<MapServerFiles> ToMapServer(const Grid<std::int8_t>& occupancy,
                                   const GridGeometry& geometry) {
  if (occupancy.rows() != geometry.rows() || occupancy.cols() != geometry.cols()) {
    return InvalidArgument("occupancy of " + std::to_string(occupancy.rows()) + " x " +
                           std::to_string(occupancy.cols()) + " cells for a world of " +
                           std::to_string(geometry.rows()) + " x " +
                           std::to_string(geometry.cols()));
  }
  const auto illegal = std::find_if(occupancy.begin(), occupancy.end(), [](std::int8_t value) {
    return value < kUnknown || value > 100;
  });
  if (illegal != occupancy.end()) {
    return InvalidArgument("occupancy is 0 to 100, or -1 where unknown, not " +
                           std::to_string(*illegal));
  }
  const bool raw = std::find(occupancy.begin(), occupancy.end(), kUnknown) != occupancy.end();

  MapServerFiles files;
  files.pgm = "P5\n" + std::to_string(occupancy.cols()) + " " + std::to_string(occupancy.rows()) +
              "\n255\n";
  files.pgm.reserve(files.pgm.size() + occupancy.size());
  for (const std::int8_t value : occupancy)
    files.pgm.push_back(static_cast<char>(raw ? GreyOfRaw(value) : GreyOfScaled(value)));
  const std::string corner_m = FormatDouble(-geometry.half_size_m());
  files.yaml = "image: map.pgm\nresolution: " + FormatDouble(geometry.resolution_m()) +
               "\norigin: [" + corner_m + ", " + corner_m +
               ", 0]\nnegate: 0\noccupied_thresh: " + FormatDouble(kOccupiedThreshold) +
               "\nfree_thresh: " + FormatDouble(kFreeThreshold) +
               "\nmode: " + (raw ? "raw" : "scale") + "\n";
  return files;
}

}  // namespace latticeworld
