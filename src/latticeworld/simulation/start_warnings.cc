#include "latticeworld/simulation/start_warnings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "latticeworld/common/text.h"
#include "latticeworld/scene/agents/spawn_rules.h"

namespace latticeworld {
namespace {

constexpr double kSame_m = 1e-3;

std::string TextOf(WorldPoint place) {
  char text[64];
  std::snprintf(text, sizeof(text), "(%.2f, %.2f)", place.x_m, place.y_m);
  return text;
}

}  // namespace

std::vector<std::string> StartWarnings(const Scene& scene, const WorldState& state,
                                       const SpeciesCatalogue& catalogue) {
  std::vector<std::string> warnings;
  for (const AgentStart& start : scene.agents) {
    const auto agent =
        std::find_if(state.agents.begin(), state.agents.end(),
                     [&start](const AgentSnapshot& one) { return one.name == start.name; });
    if (agent == state.agents.end()) continue;
    const Species* species = catalogue.Find(agent->species);
    if (species == nullptr || species->radius_m <= BodyRadius(start.category)) continue;
    const WorldPoint place = {agent->position_m.x(), agent->position_m.y()};
    const std::string body = species->name + " of radius " + FormatDouble(species->radius_m) + " m";
    if (std::hypot(place.x_m - start.position.x_m, place.y_m - start.position.y_m) > kSame_m) {
      warnings.push_back(start.name + " begins at " + TextOf(place) + ": at its start " +
                         TextOf(start.position) + " there is no room for a " + body);
    } else if (const Status fits =
                   CheckSpawn(scene, scene.atmosphere, species->category, species->radius_m, place);
               !fits.ok()) {
      warnings.push_back(start.name + " begins where there is no room for a " + body +
                         ", for none was found near: " + fits.message());
    }
  }
  return warnings;
}

}  // namespace latticeworld
