#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_STATE_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_STATE_H_

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/item_cursor.h"
#include "latticeworld/language/grounded/mention.h"
#include "latticeworld/language/grounded/not_understood.h"

namespace latticeworld {

// What the readers of a layout instruction share: how far it is read, what it said so far, and what
// the words that come belong to.
struct ReadingState {
  ReadingState(std::string_view text, Vocabulary words)
      : instruction(text), vocabulary(words), cursor(text), unknown(text) {}

  Mention* mention(int index) { return &reading.mentions[static_cast<std::size_t>(index)]; }
  // The mention's words reach at least to here.
  void Extend(int index) {
    mention(index)->end = std::max(mention(index)->end, cursor.EndOf(cursor.Item()));
  }
  std::string QuoteOf(std::size_t begin, std::size_t end) const {
    return Quote(instruction.substr(begin, end - begin));
  }
  void AddUnknown(const LayoutItem& item) { unknown.Add(cursor.BeginOf(item), cursor.EndOf(item)); }

  std::string_view instruction;
  Vocabulary vocabulary;
  ItemCursor cursor;
  NotUnderstood unknown;
  LayoutReading reading;

  int last = -1;           // the mention that words after it belong to
  int line = -1;           // the line that a course belongs to
  std::vector<int> group;  // mentions that share the place that comes
  bool group_has_and = false;
  std::vector<Place> lead;  // "In the north there is ..."
  std::size_t lead_begin = 0;
  bool lead_used = false;
  bool clause_has_noun = false;
  bool sentence_has_noun = false;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_STATE_H_
