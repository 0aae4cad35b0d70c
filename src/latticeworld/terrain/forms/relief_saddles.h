#ifndef LATTICEWORLD_TERRAIN_FORMS_RELIEF_SADDLES_H_
#define LATTICEWORLD_TERRAIN_FORMS_RELIEF_SADDLES_H_

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/terrain/forms/relief_places.h"

namespace latticeworld::internal {

// A pass between two rises, on a height field.
struct SaddleRelief {
  WorldPoint pass;
  double pass_m = 0.0;  // the highest level at which land joins the two tops (their key col)
  double top_m = 0.0;   // of the lower of them
  double side_m = 0.0;  // of the higher of the two sides that the land falls to from the pass
};

// Measures the saddle between two round pieces. The sides lie one half width from the pass, across
// the line from top to top; each is as high as the median ground around it.
SaddleRelief MeasureSaddle(const ReliefPiece& one, const ReliefPiece& other,
                           const GridGeometry& geometry, const Grid<float>& height_m);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_FORMS_RELIEF_SADDLES_H_
