#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_SURFACES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_SURFACES_H_

#include <vector>

#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// What is said of land and of what stands on it, and of where agents act:
// - "stones wet and mossy": stones mossy, which is no rain;
// - "sheets of ice cover the lake": the lake is covered with ice;
// - "the grass is not dense but the forest is": but the forest is dense;
// - "two thirds of the ground are covered by flowers": 67 percent of the ground are covered ...;
// - "flowers more than half": flowers more than 50 percent;
// - "under attack by goblins": attacked by goblins; "drones hang over the lake": drones hover.
void MendSurfaces(const EnvironmentWords& words, std::vector<Token>* tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_SURFACES_H_
