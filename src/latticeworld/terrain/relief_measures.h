#ifndef LATTICEWORLD_TERRAIN_RELIEF_MEASURES_H_
#define LATTICEWORLD_TERRAIN_RELIEF_MEASURES_H_

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/terrain/relief_places.h"

namespace latticeworld::internal {

// Distance of a place from the axis of a piece [m]; its piece is no area.
double DistanceToAxis_m(const ReliefPiece& piece, WorldPoint at);
// The same beside a line, positive to the side that a cliff's land rises on.
double SideOfAxis_m(const ReliefPiece& piece, WorldPoint at);

// Measures on a height field [m] over the whole world (docs/relief.md).

// Of a thing with an axis: from its foot to its top or crest, from its rim to its floor, or from
// the foot of a cliff to its edge. 0 where nothing can be measured.
double Amplitude_m(const ReliefPiece& piece, const GridGeometry& geometry,
                   const Grid<float>& height_m);
// The slope of a thing's flanks [deg]: the median between a third and two thirds of the way from
// axis to foot.
double FlankSlope_deg(const ReliefPiece& piece, const GridGeometry& geometry,
                      const Grid<float>& height_m);

// Of the dry cells of an area.
struct AreaRelief {
  double relief_m = 0.0;      // from the lowest to the highest
  double spread_m = 0.0;      // from the 2nd to the 98th percentile
  double slope_deg = 0.0;     // median
  double rise_m = 0.0;        // of the plane that fits best, over the world's side, toward heading
  double ruggedness_m = 0.0;  // standard deviation around that plane
};
// level_m: of water, NaN where dry.
AreaRelief MeasureArea(const ReliefPiece& piece, const GridGeometry& geometry,
                       const Grid<float>& height_m, const Grid<float>& level_m);

// How deep the deepest hollow near a piece is that no water leaves [m]; the surface of water counts
// as ground.
double HollowDepth_m(const ReliefPiece& piece, const GridGeometry& geometry,
                     const Grid<float>& height_m);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_RELIEF_MEASURES_H_
