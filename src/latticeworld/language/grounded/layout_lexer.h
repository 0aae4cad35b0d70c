#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_LAYOUT_LEXER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_LAYOUT_LEXER_H_

#include <cstddef>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/layout_words.h"
#include "latticeworld/language/grounded/places.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

enum class LayoutItemKind { kNoun, kPlace, kWord, kNumber, kComma, kStop, kUnknown };

// A phrase of a layout instruction, read.
struct LayoutItem {
  LayoutItemKind kind = LayoutItemKind::kUnknown;
  LayoutWord word = LayoutWord::kNone;  // kWord
  const ClassWord* noun = nullptr;      // kNoun
  bool plural = false;                  // kNoun
  std::vector<Place> places;            // kPlace
  bool relative = false;                // kPlace: "north" of "north of the lake"
  int number = 0;                       // kNumber
  std::size_t first = 0;                // tokens [first, last)
  std::size_t last = 0;
};

std::vector<LayoutItem> LexLayout(const std::vector<Token>& tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_LAYOUT_LEXER_H_
