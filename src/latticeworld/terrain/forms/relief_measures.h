#ifndef LATTICEWORLD_TERRAIN_FORMS_RELIEF_MEASURES_H_
#define LATTICEWORLD_TERRAIN_FORMS_RELIEF_MEASURES_H_

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/terrain/forms/relief_places.h"

namespace latticeworld::internal {

// Distance of a place from the axis of a piece [m]; its piece is no area.
double DistanceToAxis_m(const ReliefPiece& piece, WorldPoint at);
// The same beside a line, positive to the side that a cliff's land rises on.
double SideOfAxis_m(const ReliefPiece& piece, WorldPoint at);

// Measures on a height field [m] over the whole world (docs/relief.md).

// Returns the height of a thing with an axis: from its foot to its top or crest, from its rim to
// its floor, or from the foot of a cliff to its edge. 0: nothing can be measured.
double Amplitude_m(const ReliefPiece& piece, const GridGeometry& geometry,
                   const Grid<float>& height_m);
// The slope of a thing's flanks [deg]: the median between a third and two thirds of the way from
// axis to foot.
double FlankSlope_deg(const ReliefPiece& piece, const GridGeometry& geometry,
                      const Grid<float>& height_m);

// The level of the ground around a thing with an axis: the median of the ring from its foot to a
// quarter beyond it [m]; NaN where there is none.
double FootLevel_m(const ReliefPiece& piece, const GridGeometry& geometry,
                   const Grid<float>& height_m);
// Returns the width across a thing: twice the distance from its axis at which the median ground has
// come within a tenth of its height of its foot, or of its rim; of a crater from rim to rim. 0: it
// never does.
double Width_m(const ReliefPiece& piece, const GridGeometry& geometry, const Grid<float>& height_m);
// Returns the length along a thing that runs: of its axis, and of what lies beyond the axis' ends,
// the part whose sections are at least half as high as the thing.
double Length_m(const ReliefPiece& piece, const GridGeometry& geometry,
                const Grid<float>& height_m);
// The highest ground on a round thing, or the lowest in it; of one that runs the middle of its
// axis, of an area its middle.
WorldPoint MiddleOf(const ReliefPiece& piece, const GridGeometry& geometry,
                    const Grid<float>& height_m);

// Measures of the dry cells of an area.
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

#endif  // LATTICEWORLD_TERRAIN_FORMS_RELIEF_MEASURES_H_
