#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LINES_LINE_SHAPES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LINES_LINE_SHAPES_H_

#include "latticeworld/common/random.h"
#include "latticeworld/layout/layout_mask.h"

namespace latticeworld {

// Lines that have no two ends. zone: where they lie, never empty.
// A closed loop around the middle of the zone, one cell wide, not quite a circle.
LayoutMask LoopLine(const LayoutMask& zone, RandomStream* random);
// Streets both ways, three or four cells apart, about the middle of the zone.
LayoutMask StreetGrid(const LayoutMask& zone, RandomStream* random);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LINES_LINE_SHAPES_H_
