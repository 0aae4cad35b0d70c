#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_SETTLE_PLAN_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_SETTLE_PLAN_H_

#include "latticeworld/language/grounded/layout_plan.h"

namespace latticeworld {

// Gives a plan what the words leave open: its background; and takes out what they take back: of a
// class that is asked for and denied, the later words count, with a warning. `plan` holds its
// features in the order of the words, and no claims yet.
void SettlePlan(LayoutPlan* plan);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_SETTLE_PLAN_H_
