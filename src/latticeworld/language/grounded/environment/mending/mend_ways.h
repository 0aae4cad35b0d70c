#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_WAYS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_WAYS_H_

#include <vector>

#include "latticeworld/language/tokens.h"

namespace latticeworld {

// Places told by where ways lead:
// - "where the road crosses the river": at the bridge;
// - "where the road enters the village": on the road by the village;
// - "halfway along the road", "two halfway": in the middle of the road, two in the middle.
void MendWays(std::vector<Token>* tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_WAYS_H_
