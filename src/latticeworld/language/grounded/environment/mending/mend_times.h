#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_TIMES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_TIMES_H_

#include <vector>

#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// What was, or will be, and is not now; and where the sun is:
// - "it was raining this morning, but now the sun is out": but now the sun is out;
// - "the rain of this morning is over": the rain is over;
// - "rain is expected tonight; now it is sunny": now it is sunny;
// - "I was thinking of a storm, but a cloudy day will do": a cloudy day will do;
// - "the sun has set", "the sun has not yet risen": dusk, dawn;
// - "a plain cloudy day": a cloudy day.
void MendTimes(const EnvironmentWords& words, std::vector<Token>* tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_TIMES_H_
