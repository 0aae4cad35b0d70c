#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_DENIALS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_DENIALS_H_

#include <vector>

#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// What is not there, in the form that is read best:
// - "zero robots", "not any robots", "windspeed=0": no robots, no wind;
// - "snow? None.": no snow;
// - "cancel the rain", "forget about the dogs": no the rain, no the dogs;
// - "of the warriors none remain": no the warriors;
// - "nothing on the bridge but a horse": on the bridge nothing but a horse;
// - "with no moving": without moving.
void MendDenials(const EnvironmentWords& words, std::vector<Token>* tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_DENIALS_H_
