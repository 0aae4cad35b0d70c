#ifndef LATTICEWORLD_TESTS_LANGUAGE_GROUNDED_SYNTHESIS_SYNTHESIS_PLANS_H_
#define LATTICEWORLD_TESTS_LANGUAGE_GROUNDED_SYNTHESIS_SYNTHESIS_PLANS_H_

#include <string>
#include <vector>

#include "latticeworld/language/grounded/layout_plan.h"

namespace latticeworld {

// A plan as a reader of instructions would make it, with its claims, written by hand.
struct NamedPlan {
  std::string name;
  LayoutPlan plan;
};
std::vector<NamedPlan> SynthesisPlans();

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_LANGUAGE_GROUNDED_SYNTHESIS_SYNTHESIS_PLANS_H_
