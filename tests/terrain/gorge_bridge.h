#ifndef LATTICEWORLD_TESTS_TERRAIN_GORGE_BRIDGE_H_
#define LATTICEWORLD_TESTS_TERRAIN_GORGE_BRIDGE_H_

#include "latticeworld/terrain/ways/bridge.h"

namespace latticeworld {

// A road's bridge along x over a gorge whose bed lies at bed_m, a centimetre above land at 0 m:
// supports 3 m from either end and a pier in its middle.
inline Bridge BridgeOverGorge(double half_length_m, double bed_m, double load_kg) {
  Bridge bridge;
  bridge.line = {{-half_length_m, 0.0}, {half_length_m, 0.0}};
  bridge.width_m = 5.0;
  bridge.deck_z_m = 0.01;
  bridge.thickness_m = 0.4;
  bridge.water_level_m = bed_m;
  bridge.railing_m = 1.0;
  bridge.load_kg = load_kg;
  bridge.supports_m = {3.0, half_length_m, 2.0 * half_length_m - 3.0};
  return bridge;
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_TERRAIN_GORGE_BRIDGE_H_
