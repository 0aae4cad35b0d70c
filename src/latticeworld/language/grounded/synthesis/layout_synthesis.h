#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LAYOUT_SYNTHESIS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LAYOUT_SYNTHESIS_H_

#include <cstdint>

#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {

// A layout for the plan. Each attempt places a skeleton of middles and stops jointly, lays compact
// pieces, lines and land along it, and is measured by the plan's claims; the best attempt is then
// searched on until its claims hold. The effort is bounded in measured claims, so that the same
// plan, relief and seed give the same layout everywhere. Always legal; whether every claim holds is
// for the caller to measure. relief: or nullptr.
SymbolicLayout SynthesizeLayout(const LayoutPlan& plan, const Relief* relief, std::uint64_t seed);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LAYOUT_SYNTHESIS_H_
