#ifndef LATTICEWORLD_LANGUAGE_READING_CLAIM_COVERAGE_H_
#define LATTICEWORLD_LANGUAGE_READING_CLAIM_COVERAGE_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/environment/environment_claims.h"
#include "latticeworld/language/reading/coverage.h"
#include "latticeworld/layout/claims/claims.h"

namespace latticeworld {

// Counts the units of a text of which the claims came. They are carried by the sentences that say
// the claims, and by what the claims themselves ask for: classes of land, agents, numbers and
// places. Not all that a claim says is in a form of the small language.
TextCoverage CoverageOf(std::string_view text, const std::vector<std::string>& sentences,
                        const std::vector<Claim>& claims, Vocabulary vocabulary);
TextCoverage CoverageOf(std::string_view text, const std::vector<std::string>& sentences,
                        const std::vector<EnvironmentClaim>& claims, Vocabulary vocabulary);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_CLAIM_COVERAGE_H_
