#include "latticeworld/scene/spawn_rules.h"

#include "latticeworld/common/text.h"
#include "latticeworld/scene/spawn_site.h"

namespace latticeworld {

double BodyRadius(AgentCategory category) {
  switch (category) {
    case AgentCategory::kGoblin:
    case AgentCategory::kAncientWarrior:
    case AgentCategory::kRoboticDog:
    case AgentCategory::kAerialRobot:
      return 0.4;
    case AgentCategory::kHumanoidRobot:
      return 0.35;
    case AgentCategory::kSheep:
    case AgentCategory::kEagle:
    case AgentCategory::kWheeledRobot:
      return 0.6;
    case AgentCategory::kHorse:
      return 1.2;
    case AgentCategory::kWhale:
      return 3.0;
  }
  return 0.5;
}

Status CheckSpawn(const Scene& scene, const Atmosphere& atmosphere, AgentCategory category,
                  double body_radius_m, WorldPoint position) {
  const SpawnSite site = ExamineSpawn(scene, atmosphere, category, body_radius_m, position);
  if (site.flaw == SpawnFlaw::kNone) return Status();
  const bool outside =
      site.flaw == SpawnFlaw::kIllegalRadius || site.flaw == SpawnFlaw::kOutsideWorld;
  return Status(outside ? StatusCode::kOutOfRange : StatusCode::kFailedPrecondition,
                "no " + std::string(NameOf(category)) + " can be at (" +
                    FormatDouble(position.x_m) + ", " + FormatDouble(position.y_m) +
                    "): " + Describe(scene, category, body_radius_m, site));
}

Status CheckSpawn(const Scene& scene, AgentCategory category, double body_radius_m,
                  WorldPoint position) {
  return CheckSpawn(scene, scene.atmosphere, category, body_radius_m, position);
}

}  // namespace latticeworld
