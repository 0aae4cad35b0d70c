#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_CLAIMS_OF_PLAN_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_CLAIMS_OF_PLAN_H_

#include <vector>

#include "latticeworld/language/grounded/layout_plan.h"

namespace latticeworld {

// Returns what a layout of the plan is measured by: a claim for all that its features, relations,
// orders and absences say, and no more. A claim is of a class, not of a feature; what several
// features of one class would blur is left out. If claims are equal, the first stays.
std::vector<Claim> ClaimsOfPlan(const LayoutPlan& plan);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_CLAIMS_OF_PLAN_H_
