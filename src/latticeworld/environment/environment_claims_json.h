#ifndef LATTICEWORLD_ENVIRONMENT_ENVIRONMENT_CLAIMS_JSON_H_
#define LATTICEWORLD_ENVIRONMENT_ENVIRONMENT_CLAIMS_JSON_H_

#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/environment/environment_claims.h"

namespace latticeworld {

// The JSON of a claim, one example per kind:
//
//   {"kind": "coarse", "attribute": "time_of_day", "values": ["dusk", "night"], "words": "at dusk"}
//   {"kind": "density", "asset": "forest", "least": 0.7, "most": 1, "words": "dense forest"}
//   {"kind": "variant", "asset": "lake", "key": "season_variant", "values": ["frozen"]}
//   {"kind": "variant", "asset": "architecture", "key": "material", "values": ["timber", "brick"]}
//   {"kind": "parameter", "asset": "desert", "key": "wind_mps", "least": 10, "most": 20}
//   {"kind": "agents", "category": "sheep", "least_quantity": 9, "most_quantity": 9,
//    "states": ["grazing"], "positions": ["lower left"], "words": "nine sheep graze ..."}
//   {"kind": "agents", "category": ["goblin", "ancient warrior"], "least_quantity": 1}
//   {"kind": "no_agents", "category": "whale"}
//   {"kind": "no_agents", "category": ""}
//   {"kind": "total_agents", "least_quantity": 11, "most_quantity": 11}
//
// Keys of parameters: rotation_yaw [degrees], scale, height_m, wind_mps, slope_deg. May be left
// out: words; states and positions (any); one of least and most, which is then the end of the legal
// range; one of least_quantity (then 1; 0 for total_agents) and most_quantity (then kMaxAgents). A
// category is a name or an array of names, any of which will do; "" of no_agents is every one.

// An array of claims. Errors: INVALID_ARGUMENT with every violation at once, each with its JSON
// pointer, which begins with the index: parse_error, unknown_key, missing_key, wrong_type, and what
// Validate finds.
Result<std::vector<EnvironmentClaim>> ParseEnvironmentClaims(std::string_view json);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ENVIRONMENT_ENVIRONMENT_CLAIMS_JSON_H_
