#ifndef LATTICEWORLD_ENVIRONMENT_SEASON_RULES_H_
#define LATTICEWORLD_ENVIRONMENT_SEASON_RULES_H_

#include <string_view>

#include "latticeworld/environment/attributes.h"
#include "latticeworld/environment/fine_attributes.h"

namespace latticeworld {

// Whether a seasonal variant can be seen in a season: a variant that names another season cannot,
// nor ice outside of winter, nor bloom in winter, nor a cover of snow without winter or snowfall. A
// variant outside the type's table is never allowed.
bool IsAllowed(AssetType type, std::string_view season_variant, const CoarseAttributes& coarse);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ENVIRONMENT_SEASON_RULES_H_
