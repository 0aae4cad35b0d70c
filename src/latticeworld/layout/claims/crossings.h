#ifndef LATTICEWORLD_LAYOUT_CLAIMS_CROSSINGS_H_
#define LATTICEWORLD_LAYOUT_CLAIMS_CROSSINGS_H_

#include <cstdint>

#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

// How a road gets over water.
enum class Crossing : std::uint8_t {
  kNone,
  kFord,   // the river runs on over the road
  kBridge  // the road leads over the water, which runs on below
};

// The road cells of a layout that have water on two opposite sides, at most three road cells apart,
// or twelve where the road is longer than it is wide there. fords: rivers up to three cells wide
// are forded; all other water is bridged. Wild layouts have no roads.
Grid<Crossing> CrossingsOf(const SymbolicLayout& layout, bool fords);

// Marks where road and water cross in a corner of four cells, so that no cell is of both: 1 at the
// north-west corner of the south-eastern of those cells; (rows + 1) x (cols + 1).
Grid<unsigned char> CornerCrossingsOf(const SymbolicLayout& layout);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_CLAIMS_CROSSINGS_H_
