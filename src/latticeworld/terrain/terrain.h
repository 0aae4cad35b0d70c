#ifndef LATTICEWORLD_TERRAIN_TERRAIN_H_
#define LATTICEWORLD_TERRAIN_TERRAIN_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/geometry/height_field.h"
#include "latticeworld/layout/class_weights.h"
#include "latticeworld/layout/relief_wish.h"
#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/relief/relief.h"
#include "latticeworld/terrain/surface.h"
#include "latticeworld/terrain/ways/bridge.h"

namespace latticeworld {

// The ground of a world. Immutable once built; every grid has ground.geometry().
struct Terrain {
  HeightField ground;           // solid surface [m]; below water: the bed
  Grid<float> water_level_m;    // surface of the water [m], NaN: dry
  Grid<SurfaceClass> surface;   // what the ground is made of
  ClassWeights weights;         // Psi_L
  std::vector<Bridge> bridges;  // of roads over water

  const GridGeometry& geometry() const { return ground.geometry(); }
  // Depth of water above the ground at the point [m], 0 where dry.
  double WaterDepthAt(WorldPoint point) const;
  SurfaceClass SurfaceAt(WorldPoint point) const;
};

// How the built parts of the land are shaped; slopes are tangents [m/m].
struct TerrainOptions {
  double max_road_slope = 0.12;           // along roads, (0, 0.5]
  double embankment_slope = 0.5;          // of cuts and fills beside roads, [0.1, 1]; high ones are
                                          // up to twice as steep
  double max_bank_slope = 0.6;            // of the land beside water, [0.1, 1]
  double ford_depth_m = 0.12;             // of water over a ford, [0.02, 0.14]
  bool fords = false;                     // roads ford narrow rivers; see RiversAreShallow
  std::optional<BridgeKind> bridge_kind;  // none: each by its width and setting
};
std::vector<Violation> Validate(const TerrainOptions& options);

struct TerrainRequest {
  GridGeometry geometry;
  const SymbolicLayout* layout = nullptr;  // never null
  const Relief* relief = nullptr;          // variable-height scene; null: gentle procedural relief
  std::vector<ReliefWish> reliefs;         // only without a relief: given land stays as it is
  std::vector<HeightCover> covers;         // what lies above and below heights, over the layout
  std::uint64_t seed = 0;
  TerrainOptions options;
  int threads = 0;  // 0: as many as cores; the terrain is the same with any
};

// Elevation that fits the layout. Without a relief the land comes from landscape evolution with the
// layout's water as base level: gentle where its classes are, ridges and valleys in rock and snow.
// With one it stays as given but for what is built into it. Either way rivers fall along their
// course into lakes, the sea or over the world's edge, still water is level and held by its shores,
// roads keep to their slope, building land and fields on slopes lie in level steps. Roads cross
// water on bridges, and the water runs on below; where the options say so they ford rivers that are
// up to three layout cells wide, which suits those that are shallow (shallow_rivers.h).
// Errors: INVALID_ARGUMENT (options), CANCELLED.
Result<Terrain> BuildTerrain(const TerrainRequest& request, const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TERRAIN_TERRAIN_H_
