#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LAYOUT_FROM_RELIEF_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LAYOUT_FROM_RELIEF_H_

#include <cstdint>

#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {

// The layout that follows from the relief alone: water in the lows, and in the wild vocabulary rock
// and snow on the heights.
SymbolicLayout LayoutFromRelief(Vocabulary vocabulary, const Relief& relief, std::uint64_t seed);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LAYOUT_FROM_RELIEF_H_
