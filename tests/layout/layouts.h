#ifndef LATTICEWORLD_TESTS_LAYOUT_LAYOUTS_H_
#define LATTICEWORLD_TESTS_LAYOUT_LAYOUTS_H_

#include <cstdint>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

SymbolicLayout Uniform(Vocabulary vocabulary, char letter);
// Fills rows first.row .. last.row and columns first.col .. last.col, both ends included.
void Fill(SymbolicLayout* layout, CellIndex first, CellIndex last, char letter);
// Each cell a letter of its own draw.
SymbolicLayout Random(Vocabulary vocabulary, std::uint64_t seed);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_LAYOUT_LAYOUTS_H_
