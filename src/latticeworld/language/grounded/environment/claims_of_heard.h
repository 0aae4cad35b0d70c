#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_CLAIMS_OF_HEARD_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_CLAIMS_OF_HEARD_H_

#include <vector>

#include "latticeworld/environment/environment_claims.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

// What was heard, as claims about the environment. Places that a layout's features name ("by the
// lake") are claimed only where the layout is given.
std::vector<EnvironmentClaim> ClaimsOf(const HeardEnvironment& heard, const SymbolicLayout* layout);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_CLAIMS_OF_HEARD_H_
