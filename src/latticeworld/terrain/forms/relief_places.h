#ifndef LATTICEWORLD_TERRAIN_FORMS_RELIEF_PLACES_H_
#define LATTICEWORLD_TERRAIN_FORMS_RELIEF_PLACES_H_

#include <vector>

#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/layout/layout_mask.h"
#include "latticeworld/layout/relief_wish.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld::internal {

// A piece of relief where it goes in a layout. A piece has an area, or an axis: one point where it
// is round, several where it runs.
struct ReliefPiece {
  int wish = 0;  // index of what asked for it
  ReliefKind kind = ReliefKind::kHill;
  LayoutMask area;
  std::vector<WorldPoint> axis;
  bool follows_water = false;  // the axis is the water of `area`
  double half_width_m = 0.0;   // from the axis to the foot, or to the rim; of an area: to its rim
  double height_m = 0.0;       // from foot to top, or from rim to floor; > 0
  Claim::Heading heading{0, -1};    // that it rises to: kCliff, kSlope, kDunes, kTerraces
  double shown_half_width_m = 0.0;  // of an area: the same, where the world's edge is a rim too
  bool rises_by_class = false;      // of an area: its class makes the mountains that are asked for
  bool carries_built = false;       // what is built is said to stand in it or on it
  bool has_area() const { return axis.empty(); }
};

// Places each wish on the cells of its letter, else on free land of its zones, as far from roads,
// buildings and water as can be. Its height is what is asked, as far as its width lets it rise. A
// function of its arguments alone, so that who measures finds what was laid.
std::vector<ReliefPiece> PlaceReliefs(const std::vector<ReliefWish>& wishes,
                                      const SymbolicLayout& layout, double size_m);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_FORMS_RELIEF_PLACES_H_
