#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LINES_LINE_COPIES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LINES_LINE_COPIES_H_

#include "latticeworld/language/grounded/layout_plan.h"

namespace latticeworld {

// The plan with a feature for each of several lines that it has in one ("two parallel streets"):
// copies come after the other features. What the plan says of the lines among themselves (parallel,
// crossing, something between them) then ties one to the other.
LayoutPlan WithLineCopies(const LayoutPlan& plan);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LINES_LINE_COPIES_H_
