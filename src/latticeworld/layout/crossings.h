#ifndef LATTICEWORLD_LAYOUT_CROSSINGS_H_
#define LATTICEWORLD_LAYOUT_CROSSINGS_H_

#include <cstdint>

#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

// How a road gets over water.
enum class Crossing : std::uint8_t {
  kNone,
  kFord,      // the river is narrow and runs on over the road
  kCauseway,  // the water is wide, and the road lies on a dam; both sides have one level
};

// The road cells of a layout that have water on two opposite sides, at most two road cells apart.
// Rivers up to three cells wide are forded. Wild layouts have no roads.
Grid<Crossing> CrossingsOf(const SymbolicLayout& layout);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_CROSSINGS_H_
