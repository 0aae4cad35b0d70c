#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_EXCEPTIONS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_EXCEPTIONS_H_

#include <vector>

#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// Who is left out of what is said of all others:
// - "every robot patrols except the two drones": all robots patrol except the two drones;
// - "except for two horses there are no animals": there are no animals except two horses;
// - "the world is empty except for one whale": the world is empty but for one whale;
// - "everything but robots": no robots.
void MendExceptions(const EnvironmentWords& words, std::vector<Token>* tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_EXCEPTIONS_H_
