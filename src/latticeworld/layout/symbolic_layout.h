#ifndef LATTICEWORLD_LAYOUT_SYMBOLIC_LAYOUT_H_
#define LATTICEWORLD_LAYOUT_SYMBOLIC_LAYOUT_H_

#include <string>
#include <string_view>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

inline constexpr int kLayoutSize = 32;  // p of the method

// y_L: 32 x 32 letters of one vocabulary, row 0 north, column 0 west.
struct SymbolicLayout {
  Vocabulary vocabulary = Vocabulary::kSuburb;
  Grid<char> cells;  // (kLayoutSize x kLayoutSize), letters of the vocabulary
};

// Reads 32 lines of 32 letters, separated by '\n' (a final one and '\r' before it are allowed).
// Errors: INVALID_ARGUMENT with every violation at once: wrong_line_count, wrong_line_length,
// foreign_letter, each with row and column counted from 1.
Result<SymbolicLayout> ParseLayout(std::string_view text, Vocabulary vocabulary);

// 32 lines of 32 letters, each ended by '\n'.
std::string ToText(const SymbolicLayout& layout);

// The same with ANSI colours, two columns a cell, for terminals.
std::string ToColoredText(const SymbolicLayout& layout);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_SYMBOLIC_LAYOUT_H_
