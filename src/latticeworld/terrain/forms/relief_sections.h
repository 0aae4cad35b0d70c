#ifndef LATTICEWORLD_TERRAIN_FORMS_RELIEF_SECTIONS_H_
#define LATTICEWORLD_TERRAIN_FORMS_RELIEF_SECTIONS_H_

#include "latticeworld/layout/relief_wish.h"

namespace latticeworld::internal {

// Rises from 0 at t = 0 to 1 at t = 1, level at both ends and beyond.
float SmoothStep(float t);

// The section of a kind: how high, or how deep, it is by the distance from its axis in half widths,
// in shares of its height. A crater's has its sign.
float Section(ReliefKind kind, float half_widths);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_FORMS_RELIEF_SECTIONS_H_
