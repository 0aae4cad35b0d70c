#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_RANGES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_RANGES_H_

#include <string_view>
#include <vector>

#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// Puts bounds of counts into the turns that the readers know: signs ("5+ drones", "> 10 sheep") in
// words, two bounds ("at least 5 but at most 10 sheep") and a number with what it may be off by
// ("100
// +/- 10") as a range, "the number of sheep must not exceed 40" as at most 40 sheep. Rewritten in
// `tokens`.
void MendRanges(const EnvironmentWords& words, std::string_view instruction,
                std::vector<Token>* tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_RANGES_H_
