#ifndef LATTICEWORLD_DATASET_CAPTIONS_CAPTION_CHECKS_H_
#define LATTICEWORLD_DATASET_CAPTIONS_CAPTION_CHECKS_H_

#include <string_view>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/layout/claims/claims.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

// Whether the words of whoever wrote them agree with what they are about, as the grounded reader
// reads them. Errors: INVALID_ARGUMENT with every violation at once, in words for who wrote.

// A layout caption: not_prose (empty, too long, a matrix, no UTF-8), contradiction (a claim that
// does not hold), says_too_little (fewer than least_claims). claims: those that were read, where
// OK.
Status CheckLayoutCaption(std::string_view text, const SymbolicLayout& layout, int least_claims,
                          std::vector<Claim>* claims);

// The description of a configuration: not_prose, contradiction, and left_out (season, time of day,
// weather, style or a group of agents that the words do not lead back to; what comes without words
// may be left out). size_m: side of the world.
Status CheckEnvironmentCaption(std::string_view text, const SymbolicLayout& layout,
                               const EnvironmentConfig& environment, double size_m);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_CAPTIONS_CAPTION_CHECKS_H_
