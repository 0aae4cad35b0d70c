#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_LEXEME_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_LEXEME_H_

#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/extents.h"
#include "latticeworld/language/grounded/reading/sense.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

enum class LexemeKind {
  kNoun,       // names a class: "pine forest"
  kPlace,      // of the map: "the northern half"
  kDirection,  // from something: "north of", "on its western shore"
  kAxis,       // "west to east"
  kCount,
  kShare,
  kSize,
  kSense,  // anything that data/layout_senses.txt knows
  kComma,
  kStop,
  kUnknown,
};

// How a direction is meant.
enum class DirectionUse {
  kBeyond,  // "north of the lake"
  kAtSide,  // "on the northern shore of the lake": also touching it
  kInside,  // "in the north of the forest"
};

// One or more tokens that mean one thing.
struct Lexeme {
  LexemeKind kind = LexemeKind::kUnknown;
  Sense sense = Sense::kNone;
  std::size_t first = 0;  // tokens [first, last)
  std::size_t last = 0;
  const ClassWord* noun = nullptr;
  bool plural = false;
  std::vector<Place> places;
  bool whole = false;  // kPlace: said to be all of it
  bool band = false;   // kPlace: one of the stripes that the map is cut into
  DirectionUse use = DirectionUse::kBeyond;
  Heading heading;
  bool of_it = false;  // the words name their object themselves: "to its north", "on its shore"
  AxisMatch axis;
  CountMatch count;
  ShareMatch share;
  SizeMatch size;

  bool Is(Sense which) const { return kind == LexemeKind::kSense && sense == which; }
};

// The longest reading wins; among equals a noun, then a place, a share, a count, a size, a sense.
std::vector<Lexeme> LexLayout(const std::vector<Token>& tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_LEXEME_H_
