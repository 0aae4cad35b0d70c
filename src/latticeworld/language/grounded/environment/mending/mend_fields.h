#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_FIELDS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_FIELDS_H_

#include <vector>

#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// Fields of a record, a name and a value each, as words:
// - "season: fall", "season = fall": season: autumn;
// - "hour: 1400": time 1400 hours;
// - "4 UAVs, state: patrol, area: NE": 4 UAVs, patrolling, location: NE.
void MendFields(const EnvironmentWords& words, std::vector<Token>* tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_FIELDS_H_
