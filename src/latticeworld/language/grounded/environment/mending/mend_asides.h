#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_ASIDES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_ASIDES_H_

#include <vector>

#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// Leaves out what is only said beside what is asked for, or adds what is left out:
// - "make it nine, twelve is too much for my laptop": make it nine;
// - "as for animals, three eagles": three eagles;
// - "two inspect the road, two the bridge": two at the bridge;
// - "my kids want ten sheep", "the children will not look at it": want ten sheep;
// - "she finds the realistic one boring", "I am tired of the rain": nothing;
// - "she loves horses, so five horses": so five horses;
// - "reed instead of ordinary grass": reed, which is grass itself;
// - "they go on patrolling", "they continue to graze": they patrolling, they graze.
void MendAsides(const EnvironmentWords& words, std::vector<Token>* tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_ASIDES_H_
