#ifndef LATTICEWORLD_TERRAIN_WAYS_GORGE_BRIDGES_H_
#define LATTICEWORLD_TERRAIN_WAYS_GORGE_BRIDGES_H_

#include <optional>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/layout/class_weights.h"
#include "latticeworld/layout/relief_wish.h"
#include "latticeworld/terrain/forms/relief_places.h"
#include "latticeworld/terrain/ways/bridge.h"
#include "latticeworld/terrain/ways/street_network.h"
#include "latticeworld/terrain/ways/way_finder.h"

namespace latticeworld::internal {

// A road of the layout that leads from one side of a gorge or canyon to the other.
struct RoadOverGorge {
  int piece = 0;                  // index of the gorge's
  std::vector<CellIndex> course;  // cells of the lattice, from side to side
};

// road: 1 on the layout's roads, on the lattice. Gorges that follow water are none: there roads
// have bridges over the water.
std::vector<RoadOverGorge> RoadsOverGorges(const std::vector<ReliefPiece>& pieces,
                                           const GridGeometry& lattice,
                                           const Grid<unsigned char>& road);

// 1 on the roads' cells near those courses, which a gorge is cut below.
Grid<unsigned char> CellsOverGorges(const std::vector<RoadOverGorge>& roads,
                                    const GridGeometry& lattice, const Grid<unsigned char>& road);

// Bridges over gorges and canyons.
struct GorgeBridges {
  std::vector<Bridge> bridges;
  std::vector<Street> ways;          // that lead to bridges which no road of the layout has
  Grid<unsigned char> open;          // 1 below decks, from abutment to abutment: nothing is built
                                     // there; empty without bridges
  Grid<unsigned char> road_to_land;  // 1 on road of the layout that the bridges take the place of
};

// What they are planned on; every grid is (lattice x lattice).
struct GorgeGround {
  const GridGeometry& lattice;
  const Grid<float>& height_m;            // of the land before roads are graded
  const Grid<unsigned char>& road;        // 1 on the layout's roads
  const Grid<unsigned char>& blocked;     // 1 where no way goes: water, buildings
  const DecodedLayout& lines;             // centre lines of roads
  const Grid<float>& water_level_m;       // NaN where dry
  const std::optional<BridgeKind>& kind;  // of every bridge; none: girders
  double max_slope = 0.0;                 // above which ways find ground dear [m/m]
};

// A bridge for every road over a gorge, level from rim to rim, and for every gorge that a bridge is
// said to lead over and no road crosses: at its narrowest place in the middle of the world, with
// ways from there to the next roads, or to the world's edge.
GorgeBridges PlanGorgeBridges(const std::vector<ReliefWish>& wishes,
                              const std::vector<ReliefPiece>& pieces,
                              const std::vector<RoadOverGorge>& roads, const GorgeGround& ground);

// Gives road below bridges to the class of the land around it.
// letters: of the largest weight of each cell.
void RoadToLand(const Grid<unsigned char>& road_to_land, SmoothedMasks* masks, Grid<char>* letters);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_WAYS_GORGE_BRIDGES_H_
