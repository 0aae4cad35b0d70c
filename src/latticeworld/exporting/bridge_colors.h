#ifndef LATTICEWORLD_EXPORTING_BRIDGE_COLORS_H_
#define LATTICEWORLD_EXPORTING_BRIDGE_COLORS_H_

#include <string>

#include "latticeworld/common/text.h"
#include "latticeworld/rendering/looks/bridge_looks.h"

namespace latticeworld {

// Red, green, blue and opacity in [0, 1], as SDF and MJCF write them.
inline std::string ExportedColorOf(BridgeKind kind, BridgePartKind part) {
  const Color bgr = ColorOfBridge(kind, part, part == BridgePartKind::kDeck);
  return FormatDouble(bgr[2]) + " " + FormatDouble(bgr[1]) + " " + FormatDouble(bgr[0]) + " 1";
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_BRIDGE_COLORS_H_
