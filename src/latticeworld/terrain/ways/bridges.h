#ifndef LATTICEWORLD_TERRAIN_WAYS_BRIDGES_H_
#define LATTICEWORLD_TERRAIN_WAYS_BRIDGES_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/layout/class_weights.h"
#include "latticeworld/terrain/water/banks.h"
#include "latticeworld/terrain/water/water_bodies.h"
#include "latticeworld/terrain/ways/bridge.h"

namespace latticeworld::internal {

// What bridges are planned on; every grid is (lattice x lattice).
struct BridgeGround {
  const GridGeometry& lattice;
  const Grid<char>& letters;
  const DecodedLayout& lines;
  const WaterBodies& water;
  const Banks& banks;
  std::optional<BridgeKind> kind;  // of every bridge; none: by its width and setting
};

// One bridge for each way that a road takes over water (Crossing::kBridge), from road to road, else
// to the world's edge, else as far as the road runs. Decks reach onto land on both sides; they lie
// as low as their clearance lets them.
std::vector<Bridge> PlanBridges(const BridgeGround& ground);

// Returns for every cell the index of the bridge whose deck is above it, or touches it, or ends
// less than apron_cells before it; else -1.
Grid<std::int32_t> CellsOfBridges(const GridGeometry& lattice, const std::vector<Bridge>& bridges,
                                  double apron_cells);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_WAYS_BRIDGES_H_
