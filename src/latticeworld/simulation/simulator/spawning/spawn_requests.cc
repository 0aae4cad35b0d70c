#include "latticeworld/simulation/simulator/spawning/spawn_requests.h"

#include <string>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/scene/agents/agent_placement.h"
#include "latticeworld/simulation/simulator/spawning/spawn_names.h"
#include "latticeworld/simulation/simulator/spawning/spawn_places.h"
#include "latticeworld/simulation/simulator/team_policies.h"

namespace latticeworld {

Result<const Species*> SpeciesFor(const SpawnRequest& request, const SpeciesCatalogue& catalogue) {
  if (request.species.empty()) return &catalogue.Of(request.category);
  if (const Species* species = catalogue.Find(request.species)) return species;
  std::vector<std::string> names;
  for (const Species& one : catalogue.all()) names.push_back(one.name);
  return InvalidArgument("there is no species " + Quote(request.species) + ": there are " +
                         Join(names, ", "));
}

Status CheckRequest(const SpawnRequest& request, const Species& species,
                    const RunningWorld& world) {
  const std::size_t agents = world.agents.all().size();
  if (agents >= static_cast<std::size_t>(kMaxAgentStarts)) {
    return ResourceExhausted("the world holds " + std::to_string(agents) +
                             " agents; it can hold no more than " +
                             std::to_string(kMaxAgentStarts));
  }
  if (!request.name.empty()) LW_RETURN_IF_ERROR(CheckNewName(request.name, world));
  if (request.state.has_value() && !CanBe(species.category, *request.state)) {
    return InvalidArgument("a " + species.name + " cannot be " +
                           std::string(NameOf(*request.state)));
  }
  LW_RETURN_IF_ERROR(Status::FromViolations("spawn", Validate(request)));
  if (request.controllable && !request.policy.empty()) {
    return InvalidArgument("a controllable agent follows its own commands: it has no policy, not " +
                           Quote(request.policy));
  }
  return Status();
}

}  // namespace latticeworld
