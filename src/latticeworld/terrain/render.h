#ifndef LATTICEWORLD_TERRAIN_RENDER_H_
#define LATTICEWORLD_TERRAIN_RENDER_H_

#include <cstdint>

#include "latticeworld/common/progress.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/layout/class_weights.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld::internal {

// A world's land, planned on its lattice; every grid is (lattice x lattice).
struct LandPlan {
  SmoothedMasks masks;
  Grid<float> height_m;  // with beds, roads and all
  Grid<float> level_m;   // of the nearest water, everywhere
  Grid<float> lowest_m;  // how low dry land may lie that no road runs over; empty without water
  Grid<float> fordable;  // 1 in water and on fords, 0 elsewhere
  Grid<float> detail;    // how much of what is finer than the lattice stays, in [0, 1]
  // The user's land before anything was shaped, on the lattice and as finely as it is known, not
  // necessarily square; empty without.
  Grid<float> given_m;
  Grid<float> fine_given_m;
};

// The terrain on its own grid: the plan, what is finer than it (undulation by class, or the user's
// relief), and the shores in detail, so that every wet cell lies below its water and every dry cell
// beside it above. Memory: what the terrain holds, and a few rows. Errors: CANCELLED.
Result<Terrain> Render(const GridGeometry& geometry, const LandPlan& plan, std::uint64_t seed,
                       int threads, const Progress& progress);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_RENDER_H_
