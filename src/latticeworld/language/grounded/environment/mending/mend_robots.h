#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_ROBOTS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_ROBOTS_H_

#include <vector>

#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// Parts of a whole that are told by their kind, with counts and nouns of their own:
// - "robots: 3 wheeled, 2 flying": 3 wheeled robots, 2 flying robots;
// - "robots: three on wheels": three robots on wheels;
// - "100 agents, half sheep, half goblins": 50 sheep, 50 goblins;
// - "60 animals: sheep and horses in equal numbers": 30 sheep and 30 horses.
void MendRobots(const EnvironmentWords& words, std::vector<Token>* tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_ROBOTS_H_
