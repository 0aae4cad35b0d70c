#ifndef LATTICEWORLD_GENERATION_FIDELITY_FIDELITY_JSON_H_
#define LATTICEWORLD_GENERATION_FIDELITY_FIDELITY_JSON_H_

#include <string>
#include <string_view>

#include "latticeworld/common/result.h"
#include "latticeworld/generation/fidelity/fidelity.h"

namespace latticeworld {

// fidelity.json: {"satisfied": 11, "claims": [{"part", "kind", "words", "satisfied", "distance",
// "explanation"}, ...], "not_understood": [...]}.
std::string EncodeFidelity(const FidelityReport& report);
// Errors: DATA_LOSS saying what is wrong: keys, types, values, a count that is not that of the
// claims.
Result<FidelityReport> DecodeFidelity(std::string_view content);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_FIDELITY_FIDELITY_JSON_H_
