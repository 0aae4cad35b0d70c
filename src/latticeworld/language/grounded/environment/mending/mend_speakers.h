#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_SPEAKERS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_SPEAKERS_H_

#include <vector>

#include "latticeworld/language/tokens.h"

namespace latticeworld {

// Who asks is no agent, and the month is no marching: "I'm a park ranger and I want a savanna": I
// want a savanna. "I am a student in robotics": nothing. "Its May": it is May. "The lambs came
// early, it's only March": it is only spring.
void MendSpeakers(std::vector<Token>* tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_SPEAKERS_H_
