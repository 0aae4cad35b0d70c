#ifndef LATTICEWORLD_ENVIRONMENT_KEEP_TO_RULES_H_
#define LATTICEWORLD_ENVIRONMENT_KEEP_TO_RULES_H_

#include <string>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/environment/environment_config.h"

namespace latticeworld {

// Makes an environment legal (Validate) and changes nothing that is: a variant or material that the
// coarse attributes forbid becomes the most usual legal one, a number the nearest legal one, a
// state that a category cannot be in "idle", and agents beyond the limits are left out, the last
// groups first. Returns what was changed and why, a sentence each: "forest season_variant cannot be
// \"spring oak\": the rule ...; it is \"winter pine\"".
std::vector<std::string> KeepToRules(const Catalogue& catalogue, EnvironmentConfig* environment);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ENVIRONMENT_KEEP_TO_RULES_H_
