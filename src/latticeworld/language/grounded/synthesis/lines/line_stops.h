#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LINES_LINE_STOPS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LINES_LINE_STOPS_H_

#include <vector>

#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/language/grounded/synthesis/canvas.h"

namespace latticeworld {

// Says where one stop of a line may lie.
struct StopChoice {
  int feature = -1;              // at this feature; then cells is empty
  std::vector<CellIndex> cells;  // any of these
  bool bend = false;             // free to move: a bend that the line may make
};

// The stops that the plan gives a line, both ends included. Ends that the words leave open may lie
// anywhere on the map's border (within the line's own zones, if it has any).
std::vector<StopChoice> StopsOf(const LayoutPlan& plan, int feature);

// Whether the line follows another feature: runs along it, beside it, or around it.
bool IsDerived(const LayoutPlan& plan, int feature);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LINES_LINE_STOPS_H_
