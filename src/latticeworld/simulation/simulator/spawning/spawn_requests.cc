#include "latticeworld/simulation/simulator/spawning/spawn_requests.h"

#include <cstddef>
#include <string>

#include "latticeworld/common/check.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/simulation/simulator/spawning/spawn_names.h"

namespace latticeworld {

Status CheckRequest(const SpawnRequest& request, const RunningWorld& world) {
  LW_RETURN_IF_ERROR(Status::FromViolations("spawn", Validate(request, *world.options.species)));
  const std::size_t agents = world.agents.all().size();
  if (agents >= static_cast<std::size_t>(kMaxAgentStarts)) {
    return ResourceExhausted("the world holds " + std::to_string(agents) +
                             " agents; it can hold no more than " +
                             std::to_string(kMaxAgentStarts));
  }
  return request.name.empty() ? Status() : CheckNewName(request.name, world);
}

const Species& SpeciesFor(const SpawnRequest& request, const SpeciesCatalogue& catalogue) {
  if (request.species.empty()) return catalogue.Of(request.category);
  const Species* species = catalogue.Find(request.species);
  LW_CHECK(species != nullptr, "the request is legal");
  return *species;
}

}  // namespace latticeworld
