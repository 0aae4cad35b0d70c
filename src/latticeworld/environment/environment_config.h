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

class RandomStream;

// y_C: the environment of a world.
struct EnvironmentConfig {
  CoarseAttributes coarse;
  FineAttributes fine;
  std::vector<AgentGroup> agents;

  const FineAttribute& fine_of(AssetType type) const { return fine[static_cast<int>(type)]; }
  FineAttribute& fine_of(AssetType type) { return fine[static_cast<int>(type)]; }
};

// The typical fine attributes under coarse ones (rules.h): of variants and materials those of the
// most weight, of equals the first; of parameters the typical values. Legal and deterministic.
FineAttributes DeriveFineAttributes(const CoarseAttributes& coarse, const Catalogue& catalogue);
FineAttributes DeriveFineAttributes(const CoarseAttributes& coarse);

// Fine attributes drawn from the distributions of the rules, numbers in hundredths. Legal; every
// legal variant and material comes up.
FineAttributes SampleFineAttributes(const CoarseAttributes& coarse, const Catalogue& catalogue,
                                    RandomStream* random);

// Every value in range, every name one of its type's in the catalogue, agents within their limits
// and able to be in their state (code conflict), and no fine value that the coarse ones forbid
// (code conflict; the message names the rule, its reason and what is legal). Functions without a
// catalogue take Catalogue::BuiltIn().
std::vector<Violation> Validate(const EnvironmentConfig& environment, const Catalogue& catalogue);
std::vector<Violation> Validate(const EnvironmentConfig& environment);

// The JSON of INTERFACES. Errors: INVALID_ARGUMENT with every violation at once, each with its JSON
// pointer: parse_error, unknown_key, missing_key, wrong_type, out_of_range, unknown_value,
// duplicate_key, and what Validate finds.
Result<EnvironmentConfig> ParseEnvironment(std::string_view json, const Catalogue& catalogue);
Result<EnvironmentConfig> ParseEnvironment(std::string_view json);
// The same without what Validate finds: shape and names are right, and no rule was asked.
Result<EnvironmentConfig> ParseUncheckedEnvironment(std::string_view json,
                                                    const Catalogue& catalogue);
// Indented by two, keys in schema order.
std::string ToJson(const EnvironmentConfig& environment, const Catalogue& catalogue);
std::string ToJson(const EnvironmentConfig& environment);

// JSON Schema (draft 2020-12) of that JSON with the catalogue's values. What it cannot say, the
// rules that bind fine values to coarse ones, stands in its description.
std::string EnvironmentSchema(const Catalogue& catalogue);
std::string EnvironmentSchema();

}  // namespace latticeworld

#endif  // LATTICEWORLD_ENVIRONMENT_ENVIRONMENT_CONFIG_H_
