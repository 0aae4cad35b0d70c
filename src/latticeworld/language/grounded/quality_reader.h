#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_QUALITY_READER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_QUALITY_READER_H_

#include <utility>

#include "latticeworld/language/grounded/reading_state.h"

namespace latticeworld {

// What was said before the noun that it belongs to.
struct Modifiers {
  Amount amount = Amount::kUnsaid;
  Texture texture = Texture::kUnsaid;
  int number = 0;
  bool few = false;
  bool several = false;
  bool many = false;
  double meander = 1.0;
  bool negated = false;
  bool is_rest = false;
  bool definite = false;
  int first_item = -1;
};

// Reads how much, how many and of what kind: of the noun that comes, or else of what was named
// last.
class QualityReader {
 public:
  explicit QualityReader(ReadingState* state) : state_(*state) {}

  // What the noun that comes will be told.
  Modifiers* Modify();
  Modifiers Take() { return std::exchange(modifiers_, Modifiers()); }
  void Forget() { modifiers_ = Modifiers(); }
  void MakeDefinite() { modifiers_.definite = true; }

  void SetAmount(Amount amount);
  void SetTexture(Texture texture);
  void SetMeander(double meander);
  void ReadCovers();
  void ReadEverywhere();
  void ReadRest();

 private:
  ReadingState& state_;
  Modifiers modifiers_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_QUALITY_READER_H_
