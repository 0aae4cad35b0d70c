#include "latticeworld/language/grounded/course_reader.h"

#include <algorithm>
#include <utility>

namespace latticeworld {

void CourseReader::BeginRun() {
  if (state_.line < 0 && state_.last >= 0 && state_.mention(state_.last)->is_line()) {
    state_.line = state_.last;
  }
  running_ = true;
  // "crosses the forest", "follows the river"
  if (state_.cursor.KindIsNext(LayoutItemKind::kNoun)) expected_ = Role::kThrough;
}

void CourseReader::BeginConnection() {
  connecting_ = true;
  expected_ = Role::kFrom;
}

void CourseReader::SetEnds(Region from, Region to) {
  if (state_.line >= 0 && !state_.cursor.NounAhead()) {
    Mention* line = state_.mention(state_.line);
    line->from = from;
    line->to = to;
    state_.Extend(state_.line);
  } else {
    pending_from_ = from;
    pending_to_ = to;
  }
}

void CourseReader::TakePendingEnds(Mention* line) {
  if (pending_from_ == Region::kAnywhere && pending_to_ == Region::kAnywhere) return;
  line->from = std::exchange(pending_from_, Region::kAnywhere);
  line->to = std::exchange(pending_to_, Region::kAnywhere);
}

CourseReader::Use CourseReader::ReadPlace(const LayoutItem& item) {
  const bool starts_pair =
      expected_ == Role::kNone && running_ && state_.cursor.NextIsWord(LayoutWord::kTo);
  if (expected_ == Role::kNone && !starts_pair) return Use::kNone;
  const Role role = starts_pair ? Role::kFrom : expected_;
  expected_ = Role::kNone;
  const Region main = item.places.front().main;
  if (state_.line < 0) {
    // "forest stretches from the north to the south": it covers both ends.
    if (state_.last >= 0 && role != Role::kThrough) return Use::kOfLast;
    if (role == Role::kFrom) pending_from_ = main;
    if (role == Role::kTo) pending_to_ = main;
    return role == Role::kThrough ? Use::kNone : Use::kTaken;
  }
  Mention* line = state_.mention(state_.line);
  if (role == Role::kFrom) {
    line->from = main;
  } else if (role == Role::kTo) {
    line->to = main;
  } else {
    line->through.push_back(main);
  }
  if (connecting_ && role == Role::kFrom) AwaitOtherEnd();
  state_.Extend(state_.line);
  std::vector<int>& group = state_.group;
  group.erase(std::remove(group.begin(), group.end(), state_.line), group.end());
  return Use::kTaken;
}

void CourseReader::Complete(int index) {
  CompleteConnection(index);
  CompleteEnd(index);
}

// "two villages, one in the north and one in the south, connected by a road"; "a lake and a
// village connected by a road".
void CourseReader::CompleteConnection(int index) {
  const int subject = std::exchange(connected_, -1);
  if (subject < 0 || !state_.mention(index)->is_line() || state_.mention(index)->negated) return;
  Mention* line = state_.mention(index);
  const std::vector<Place>& ends = state_.mention(subject)->places;
  if (ends.size() >= 2) {
    line->from = ends.front().main;
    line->to = ends.back().main;
  } else if (subject > 0) {
    line->from_mention = subject - 1;
    line->to_mention = subject;
  }
}

// A noun at the end of a course: "leads to the village", "through the forest".
void CourseReader::CompleteEnd(int index) {
  const Role role = std::exchange(expected_, Role::kNone);
  if (role == Role::kNone || state_.line < 0 || state_.line == index) return;
  Mention* line = state_.mention(state_.line);
  if (role == Role::kFrom) line->from_mention = index;
  if (role == Role::kTo) line->to_mention = index;
  if (connecting_) AwaitOtherEnd();
  const Mention& end = *state_.mention(index);
  if (end.letter == line->letter) return;
  state_.reading.ties.push_back(
      {TieKind::kNextTo, state_.line, index, {}, line->begin, std::max(line->end, end.end)});
}

// "connects the lake and the village": the word between the ends does not part them.
void CourseReader::AwaitOtherEnd() {
  connecting_ = false;
  expected_ = Role::kTo;
  if (state_.cursor.NextIsWord(LayoutWord::kAnd) || state_.cursor.NextIsWord(LayoutWord::kBreak)) {
    state_.cursor.Advance();
  }
}

void CourseReader::EndPhrase() {
  expected_ = Role::kNone;
  running_ = false;
}

void CourseReader::EndSentence() {
  connected_ = -1;
  pending_from_ = pending_to_ = Region::kAnywhere;
}

}  // namespace latticeworld
