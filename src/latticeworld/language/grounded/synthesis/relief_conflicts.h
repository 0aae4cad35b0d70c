#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_RELIEF_CONFLICTS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_RELIEF_CONFLICTS_H_

#include <string>
#include <vector>

#include "latticeworld/layout/claims/claims.h"
#include "latticeworld/layout/vocabulary.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {

// A warning for each claim whose words ask for snow or rock where the relief is low, for water
// where it is high, or for water that runs from low to high land. The words are obeyed all the
// same.
std::vector<std::string> ReliefConflicts(const std::vector<Claim>& claims, Vocabulary vocabulary,
                                         const Relief& relief);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_RELIEF_CONFLICTS_H_
