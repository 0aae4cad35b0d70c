#ifndef LATTICEWORLD_RENDERING_LOOKS_BRIDGE_COLORS_H_
#define LATTICEWORLD_RENDERING_LOOKS_BRIDGE_COLORS_H_

#include "latticeworld/common/rgb.h"
#include "latticeworld/terrain/ways/bridge.h"

namespace latticeworld {

// The natural colour of a part of a bridge; top: of what is driven on.
Rgb RgbOfBridge(BridgeKind kind, BridgePartKind part, bool top);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_LOOKS_BRIDGE_COLORS_H_
