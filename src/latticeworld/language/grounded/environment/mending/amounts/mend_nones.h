#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_NONES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_NONES_H_

#include <vector>

#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// What agents do not do, though they are there, and what all of them are:
// - "no goblin is attacking", "no goblin attacks": the goblins are not attacking;
// - "nobody watches the sheep", "nobody guards the village": the sheep, the village;
// - "ten rovers, none moving", "not one of them moving": none of them moving;
// - "five drones, none on the ground": all in the air;
// - "ten robots, all wheeled", "..., all of them drones": ten wheeled robots, ten drones.
void MendNones(const EnvironmentWords& words, std::vector<Token>* tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_NONES_H_
