#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_TIE_READER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_TIE_READER_H_

#include "latticeworld/language/grounded/reading_state.h"

namespace latticeworld {

// Reads what ties two mentions together: "next to", "surrounded by", "north of", "between",
// "more ... than".
class TieReader {
 public:
  explicit TieReader(ReadingState* state) : state_(*state) {}

  // passive: the one named first is the object ("a lake surrounded by forest").
  void Begin(TieKind kind, bool passive);
  void BeginHeading(Heading heading);
  void BeginBetween();
  void BeginComparison(bool more) { comparing_ = more ? 1 : -1; }
  // A noun was read.
  void Complete(int index, std::size_t begin, std::size_t end);

  bool is_open() const { return open_; }
  // "near the center" is a place, not a tie.
  void DropNextTo() { open_ = open_ && tie_.kind != TieKind::kNextTo; }
  void EndClause() { open_ = open_ && tie_.subject < 0; }
  void EndSentence();

 private:
  void CompleteTie(int index, std::size_t begin, std::size_t end);
  void CompleteComparison(int index);

  ReadingState& state_;
  Tie tie_;
  bool open_ = false;
  bool passive_ = false;
  int object_first_ = -1;
  int between_ = 0;  // objects still to come
  int between_subject_ = -1;
  int comparing_ = 0;  // 1 more, -1 less
  int compared_ = -1;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_TIE_READER_H_
