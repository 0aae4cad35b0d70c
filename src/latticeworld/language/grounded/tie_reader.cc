#include "latticeworld/language/grounded/tie_reader.h"

#include <algorithm>
#include <utility>

namespace latticeworld {

void TieReader::Begin(TieKind kind, bool passive) {
  tie_ = Tie();
  tie_.kind = kind;
  passive_ = passive;
  tie_.subject = state_.last;
  open_ = true;
  tie_.begin = state_.last >= 0 ? state_.mention(state_.last)->begin
                                : state_.cursor.BeginOf(state_.cursor.Item());
}

void TieReader::BeginHeading(Heading heading) {
  Begin(TieKind::kHeading, false);
  tie_.heading = heading;
}

void TieReader::BeginBetween() {
  between_subject_ = state_.line >= 0 ? state_.line : state_.last;
  between_ = 2;
  state_.group.clear();
}

void TieReader::Complete(int index, std::size_t begin, std::size_t end) {
  CompleteTie(index, begin, end);
  CompleteComparison(index);
}

void TieReader::CompleteTie(int index, std::size_t begin, std::size_t end) {
  if (between_ > 0 && between_subject_ >= 0 && between_subject_ != index) {
    state_.reading.ties.push_back({TieKind::kNextTo,
                                   between_subject_,
                                   index,
                                   {},
                                   state_.mention(between_subject_)->begin,
                                   end});
    --between_;
  }
  if (!open_ || tie_.subject == index) return;
  if (tie_.subject < 0) {
    // "Next to the lake lies a village": the object came first.
    if (object_first_ < 0) {
      object_first_ = index;
      return;
    }
    tie_.subject = index;
    tie_.object = std::exchange(object_first_, -1);
  } else {
    tie_.object = index;
  }
  open_ = false;
  if (state_.mention(tie_.subject)->negated || state_.mention(tie_.object)->negated) return;
  if (passive_) std::swap(tie_.subject, tie_.object);
  tie_.begin = std::min(tie_.begin, begin);
  tie_.end = end;
  state_.reading.ties.push_back(tie_);
}

void TieReader::CompleteComparison(int index) {
  if (comparing_ == 0) return;
  if (compared_ < 0) {
    compared_ = index;
    return;
  }
  Tie tie;
  tie.kind = TieKind::kMoreThan;
  tie.subject = comparing_ > 0 ? compared_ : index;
  tie.object = comparing_ > 0 ? index : compared_;
  tie.begin = state_.mention(compared_)->begin;
  tie.end = state_.mention(index)->end;
  state_.reading.ties.push_back(tie);
  comparing_ = 0;
  compared_ = -1;
}

void TieReader::EndSentence() {
  open_ = false;
  object_first_ = -1;
  between_ = 0;
  comparing_ = 0;
  compared_ = -1;
}

}  // namespace latticeworld
