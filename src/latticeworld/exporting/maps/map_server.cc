#include "latticeworld/exporting/maps/map_server.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

struct Thresholds {
  double free, occupied;
};
constexpr double kFreeThreshold = 0.1;
constexpr double kOccupiedThreshold = 0.9;
constexpr Thresholds kOfMapSaver = {0.196, 0.65};
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

// mode trinary, as map_saver writes it: 205 is just above its free threshold, so unknown.
unsigned char GreyOfTrinary(int occupancy) {
  if (occupancy == kUnknown) return 205;
  return occupancy == 100 ? 0 : 254;
}

struct Mode {
  const char* name;
  Thresholds thresholds;
  unsigned char (*grey_of)(int occupancy);
};

Mode ModeOf(const Grid<std::int8_t>& occupancy, MapValues values) {
  if (values == MapValues::kTrinary) return {"trinary", kOfMapSaver, GreyOfTrinary};
  const bool raw = std::find(occupancy.begin(), occupancy.end(), kUnknown) != occupancy.end();
  const Thresholds thresholds = {kFreeThreshold, kOccupiedThreshold};
  return raw ? Mode{"raw", thresholds, GreyOfRaw} : Mode{"scale", thresholds, GreyOfScaled};
}

}  // namespace

Result<MapServerFiles> ToMapServer(const Grid<std::int8_t>& occupancy, const GridGeometry& geometry,
                                   MapValues values) {
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
  const Mode mode = ModeOf(occupancy, values);

  MapServerFiles files;
  files.pgm = "P5\n" + std::to_string(occupancy.cols()) + " " + std::to_string(occupancy.rows()) +
              "\n255\n";
  files.pgm.reserve(files.pgm.size() + occupancy.size());
  for (const std::int8_t value : occupancy)
    files.pgm.push_back(static_cast<char>(mode.grey_of(value)));
  const std::string corner_m = FormatDouble(-geometry.half_size_m());
  files.yaml = "image: map.pgm\nresolution: " + FormatDouble(geometry.resolution_m()) +
               "\norigin: [" + corner_m + ", " + corner_m +
               ", 0]\nnegate: 0\noccupied_thresh: " + FormatDouble(mode.thresholds.occupied) +
               "\nfree_thresh: " + FormatDouble(mode.thresholds.free) + "\nmode: " + mode.name +
               "\n";
  return files;
}

}  // namespace latticeworld
