#include "latticeworld/scene/agents/spawn_rules.h"

#include "latticeworld/common/text.h"
#include "latticeworld/scene/agents/spawn_site.h"
#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {

double BodyRadius(AgentCategory category) {
  return SpeciesCatalogue::BuiltIn()->Of(category).radius_m;
}

Status CheckSpawn(const Scene& scene, const Atmosphere& atmosphere, AgentCategory category,
                  double body_radius_m, WorldPoint position, const SceneChanges* changes) {
  const SpawnSite site =
      ExamineSpawn(scene, atmosphere, category, body_radius_m, position, changes);
  if (site.flaw == SpawnFlaw::kNone) return Status();
  const bool outside =
      site.flaw == SpawnFlaw::kIllegalRadius || site.flaw == SpawnFlaw::kOutsideWorld;
  return Status(outside ? StatusCode::kOutOfRange : StatusCode::kFailedPrecondition,
                "no " + std::string(NameOf(category)) + " can be at (" +
                    FormatDouble(position.x_m) + ", " + FormatDouble(position.y_m) +
                    "): " + Describe(scene, category, body_radius_m, site));
}

}  // namespace latticeworld
