#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_NUMERALS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_NUMERALS_H_

#include <vector>

#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// Numbers that are written in another way than they are read:
// - "two point five metres": 2.5 metres;
// - "on 4 legs", "between the 2": on four legs, between the two;
// - "50 % of them", "the other 50 % patrol": half of them, the others patrol;
// - "thirty at the very least", "thirty or more": at least thirty;
// - "seven (7) robot dogs": seven robot dogs;
// - "two out of five drones", "every second sheep": two of the five drones, half of the sheep;
// - "How many? Thirty.": thirty.
void MendNumerals(const EnvironmentWords& words, std::vector<Token>* tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_NUMERALS_H_
