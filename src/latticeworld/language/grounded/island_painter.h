#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ISLAND_PAINTER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ISLAND_PAINTER_H_

#include "latticeworld/language/grounded/canvas.h"
#include "latticeworld/language/grounded/layout_plan.h"

namespace latticeworld {

// Lays the islands into a finished layout, one after the other where the water is widest, and
// widens the water where it is too narrow to close around them. Without water nothing changes.
void PaintIslands(const IslandWish& wish, Canvas* canvas);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ISLAND_PAINTER_H_
