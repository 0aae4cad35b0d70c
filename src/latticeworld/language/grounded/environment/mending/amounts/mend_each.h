#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_EACH_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_EACH_H_

#include <vector>

#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// Counts that are told for each side or corner, or each look, as those of all of them together:
// - "two knights on each side of the bridge": four knights on each side of the bridge;
// - "two herds of horses, 8 animals each", "5 robots per team, 3 teams": 16 horses, 15 robots;
// - "a drone over each quarter of the map": four drones in all four corners;
// - "sixteen soldiers on the bridge, eight on each side": sixteen soldiers on the bridge;
// - "four rovers, one in each corner": four rovers in all four corners;
// - "one big and two small robot dogs": three robot dogs;
// - "four horses, one of them white, pull a cart": four horses pull a cart;
// - "a family of four": four people.
void MendEach(const EnvironmentWords& words, std::vector<Token>* tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_EACH_H_
