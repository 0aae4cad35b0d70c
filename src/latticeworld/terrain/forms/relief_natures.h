#ifndef LATTICEWORLD_TERRAIN_FORMS_RELIEF_NATURES_H_
#define LATTICEWORLD_TERRAIN_FORMS_RELIEF_NATURES_H_

#include "latticeworld/layout/relief_wish.h"

namespace latticeworld::internal {

// The natural measures of a kind of relief, where words say none.
struct ReliefNature {
  double half_width;  // of the world's size
  double height;      // of the half width
};
ReliefNature NatureOf(ReliefKind kind);

// The steepest mean slope [m/m] of flanks of a kind, whatever is asked.
double SteepestFlank(ReliefKind kind);

// The least height of a mountain by its width, and of land that is several mountains by the width
// of it all.
inline constexpr double kLeastMountain = 0.15;
inline constexpr double kLeastMountains = 0.10;

// The width of a kind, as words mean it, by twice its half width: from where nine tenths of the
// height are passed on one side to the same on the other; of a crater from rim to rim.
double WidthShare(ReliefKind kind);

bool IsMountain(ReliefKind kind);
// What lies lower than what is around it.
bool IsSunk(ReliefKind kind);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_FORMS_RELIEF_NATURES_H_
