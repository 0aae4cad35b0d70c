#ifndef LATTICEWORLD_LANGUAGE_REMOTE_NUMBER_STEPS_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_NUMBER_STEPS_H_

#include "latticeworld/common/range.h"

namespace latticeworld {

// NumberSteps stands for a range of numbers by a few values that every grammar can spell: the
// multiples of a step that lie in it.
class NumberSteps {
 public:
  // Takes the smallest of the usual steps that has at most 24 values in the range.
  explicit NumberSteps(const Range& range);

  int count() const { return count_; }
  // Returns the i-th value, from low to high; 0 <= i < count().
  double At(int i) const;
  // Returns whether all values are whole, and spelled so: 45, not 45.0.
  bool whole() const { return per_ == 1; }

 private:
  void Count(const Range& range);

  // The step is units / per, so that its multiples are exact.
  int units_ = 1;
  int per_ = 1;
  int first_ = 0;
  int count_ = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_NUMBER_STEPS_H_
