#ifndef LATTICEWORLD_TESTS_LANGUAGE_LOCAL_CHOSEN_INSTRUCTIONS_H_
#define LATTICEWORLD_TESTS_LANGUAGE_LOCAL_CHOSEN_INSTRUCTIONS_H_

#include "latticeworld/language/local/weights/instructions.h"

namespace latticeworld {

// Has this process compute with these instructions as long as the object lives.
class ChosenInstructions {
 public:
  explicit ChosenInstructions(Instructions instructions) { UseInstructions(instructions); }
  ~ChosenInstructions() { UseInstructions(FastestInstructions()); }
  ChosenInstructions(const ChosenInstructions&) = delete;
  ChosenInstructions& operator=(const ChosenInstructions&) = delete;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_LANGUAGE_LOCAL_CHOSEN_INSTRUCTIONS_H_
