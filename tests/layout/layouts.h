#ifndef LATTICEWORLD_TESTS_LAYOUT_LAYOUTS_H_
#define LATTICEWORLD_TESTS_LAYOUT_LAYOUTS_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

SymbolicLayout Uniform(Vocabulary vocabulary, char letter);
// Fills rows first.row .. last.row and columns first.col .. last.col, both ends included.
void Fill(SymbolicLayout* layout, CellIndex first, CellIndex last, char letter);
// Fills the cells whose centres lie at most `radius` from the centre's.
void Disc(SymbolicLayout* layout, CellIndex center, double radius, char letter);
// Draws straight lines of one cell from point to point, 8-connected.
void Line(SymbolicLayout* layout, const std::vector<CellIndex>& points, char letter);
// Each cell a letter of its own draw.
SymbolicLayout Random(Vocabulary vocabulary, std::uint64_t seed);
// Patches of many sizes, as land lies: each cell the letter of the nearest of some random points,
// with lines and stray cells over them.
SymbolicLayout Patchy(Vocabulary vocabulary, std::uint64_t seed);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_LAYOUT_LAYOUTS_H_
