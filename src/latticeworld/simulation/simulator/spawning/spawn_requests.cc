#include "latticeworld/simulation/simulator/spawning/spawn_requests.h"

#include <cmath>
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
  if (!std::isfinite(request.heading_rad)) {
    return InvalidArgument("heading must be finite, not " + FormatDouble(request.heading_rad));
  }
  if (request.position.has_value() &&
      (!std::isfinite(request.position->x_m) || !std::isfinite(request.position->y_m))) {
    return InvalidArgument("position must be finite, not " + TextOf(*request.position));
  }
  if (request.team.has_value() && (*request.team < 0 || *request.team > kMaxTeam)) {
    return InvalidArgument("team must be in [0, " + std::to_string(kMaxTeam) + "], not " +
                           std::to_string(*request.team));
  }
  if (request.controllable && !request.policy.empty()) {
    return InvalidArgument("a controllable agent follows its own commands: it has no policy, not " +
                           Quote(request.policy));
  }
  return CheckPolicy(request.policy);
}

}  // namespace latticeworld
