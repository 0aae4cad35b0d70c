#ifndef LATTICEWORLD_TERRAIN_TERRAIN_H_
#define LATTICEWORLD_TERRAIN_TERRAIN_H_

#include <cstdint>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/geometry/height_field.h"
#include "latticeworld/layout/class_weights.h"
#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/relief/relief.h"
#include "latticeworld/terrain/surface.h"

namespace latticeworld {

// The ground of a world. Immutable once built; every grid has ground.geometry().
struct Terrain {
  HeightField ground;          // solid surface [m]; below water: the bed
  Grid<float> water_level_m;   // surface of the water [m], NaN: dry
  Grid<SurfaceClass> surface;  // what the ground is made of
  ClassWeights weights;        // Psi_L

  const GridGeometry& geometry() const { return ground.geometry(); }
  // Depth of water above the ground at the point [m], 0 where dry.
  double WaterDepthAt(WorldPoint point) const;
  SurfaceClass SurfaceAt(WorldPoint point) const;
};

struct TerrainRequest {
  GridGeometry geometry;
  const SymbolicLayout* layout = nullptr;  // never null
  const Relief* relief = nullptr;          // variable-height scene; null: gentle procedural relief
  std::uint64_t seed = 0;
};

// Elevation that fits the layout: water lies low and level, snow high, roads and building pads are
// smooth. Errors: CANCELLED.
Result<Terrain> BuildTerrain(const TerrainRequest& request, const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TERRAIN_TERRAIN_H_
