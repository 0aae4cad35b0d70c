#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_COURSE_READER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_COURSE_READER_H_

#include "latticeworld/language/grounded/reading_state.h"

namespace latticeworld {

// Reads how a line runs: where from, where to, through what, how straight.
class CourseReader {
 public:
  enum class Role { kNone, kFrom, kTo, kThrough };  // of the noun or place that comes

  explicit CourseReader(ReadingState* state) : state_(*state) {}

  void Expect(Role role) { expected_ = role; }
  bool is_expecting() const { return expected_ != Role::kNone; }
  void BeginRun();
  void BeginConnection();                                // "connects"
  void BeginConnectedBy() { connected_ = state_.last; }  // "connected by"
  // Ends said at once: "from side to side".
  void SetEnds(Region from, Region to);
  // The ends that were said before their line was named.
  void TakePendingEnds(Mention* line);

  // What a place is to the course.
  enum class Use { kNone, kTaken, kOfLast };  // kOfLast: a place of what was named last
  Use ReadPlace(const LayoutItem& item);
  // A noun was read.
  void Complete(int index);

  void EndPhrase();
  void EndClause() { connecting_ = false; }
  void EndSentence();

 private:
  void CompleteConnection(int index);
  void CompleteEnd(int index);
  void AwaitOtherEnd();

  ReadingState& state_;
  Role expected_ = Role::kNone;
  bool running_ = false;
  bool connecting_ = false;
  int connected_ = -1;  // what a line that comes connects
  Region pending_from_ = Region::kAnywhere;
  Region pending_to_ = Region::kAnywhere;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_COURSE_READER_H_
