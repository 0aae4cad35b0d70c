#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_SHARES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_SHARES_H_

#include <vector>

#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// Puts shares of agents into the turns that the reader of agents knows: "50 agents, 30 % of them
// sheep" is fifteen of them, "half patrolling, half asleep" is half of them each, "of the 20
// goblins most are asleep" is most of the 20 goblins. Rewritten in `tokens`.
void MendShares(const EnvironmentWords& words, std::vector<Token>* tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_SHARES_H_
