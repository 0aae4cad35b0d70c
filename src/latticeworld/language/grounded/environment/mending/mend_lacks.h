#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_LACKS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_LACKS_H_

#include <string_view>
#include <vector>

#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// What there is little or nothing of, said in other ways than by "no":
// - "not many flowers", "hardly any people": few flowers, few people;
// - "guards: none", "rocks nowhere", "a robot-free world": no guards, no rocks, no robots;
// - "the village is abandoned": deserted, but "a deserted road" tells of the road only;
// - "it's fine if there are no sheep": nothing;
// - "no moon": moonless.
void MendLacks(const EnvironmentWords& words, std::string_view instruction,
               std::vector<Token>* tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_LACKS_H_
