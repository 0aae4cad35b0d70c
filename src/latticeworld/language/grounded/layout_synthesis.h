#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_LAYOUT_SYNTHESIS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_LAYOUT_SYNTHESIS_H_

#include <cstdint>

#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {

// A layout for the plan: courses first, then compact things, then what spreads, then the ties
// between them; the background fills the rest. Always legal; whether every claim holds is for the
// caller to measure. relief: or nullptr.
SymbolicLayout SynthesizeLayout(const LayoutPlan& plan, const Relief* relief, std::uint64_t seed);

// The layout that follows from the relief alone: water in the lows, and in the wild vocabulary rock
// and snow on the heights.
SymbolicLayout LayoutFromRelief(Vocabulary vocabulary, const Relief& relief, std::uint64_t seed);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_LAYOUT_SYNTHESIS_H_
