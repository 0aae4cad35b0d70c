#ifndef LATTICEWORLD_ENVIRONMENT_ENVIRONMENT_CONFIG_H_
#define LATTICEWORLD_ENVIRONMENT_ENVIRONMENT_CONFIG_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/environment/agent_group.h"
#include "latticeworld/environment/attributes.h"
#include "latticeworld/environment/fine_attributes.h"

namespace latticeworld {

// y_C: the environment of a world.
struct EnvironmentConfig {
  CoarseAttributes coarse;
  FineAttributes fine;
  std::vector<AgentGroup> agents;

  const FineAttribute& fine_of(AssetType type) const { return fine[static_cast<int>(type)]; }
  FineAttribute& fine_of(AssetType type) { return fine[static_cast<int>(type)]; }
};

// Fine attributes that follow from the coarse ones (winter: low vegetation density, bare foliage).
FineAttributes DeriveFineAttributes(const CoarseAttributes& coarse);

// Every value in range, every variant legal for its type, agents within their limits and able to be
// in their state, and no fine value that the coarse ones forbid.
std::vector<Violation> Validate(const EnvironmentConfig& environment);

// The JSON of INTERFACES. Errors: INVALID_ARGUMENT with every violation at once, each with its JSON
// pointer: parse_error, unknown_key, missing_key, wrong_type, out_of_range, unknown_value,
// duplicate_key, and what Validate finds.
Result<EnvironmentConfig> ParseEnvironment(std::string_view json);
std::string ToJson(const EnvironmentConfig& environment);  // indented by two, keys in schema order

// JSON Schema (draft 2020-12) of that JSON.
std::string EnvironmentSchema();

}  // namespace latticeworld

#endif  // LATTICEWORLD_ENVIRONMENT_ENVIRONMENT_CONFIG_H_
