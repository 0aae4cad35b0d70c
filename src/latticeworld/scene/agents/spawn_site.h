#ifndef LATTICEWORLD_SCENE_AGENTS_SPAWN_SITE_H_
#define LATTICEWORLD_SCENE_AGENTS_SPAWN_SITE_H_

#include <cstdint>
#include <string>

#include "latticeworld/scene/scene.h"

namespace latticeworld {

struct SceneChanges;

// What walkers and wheels can ford, what swimmers need, and what legs and wheels can stand on.
inline constexpr double kFordingDepth_m = 0.2;
inline constexpr double kSwimmingDepth_m = 2.0;
inline constexpr double kSteepestForLegs_deg = 35.0;
inline constexpr double kSteepestForWheels_deg = 30.0;

enum class SpawnFlaw : std::uint8_t {
  kNone,
  kIllegalRadius,
  kOutsideWorld,
  kSolid,
  kTooDeep,
  kTooShallow,
  kTooSteep
};
inline constexpr int kSpawnFlawCount = 7;

// The steepest ground that a body of the category stands still on, whichever way it looks [deg]: no
// steeper than its species goes onto, and on wheels no steeper than the grip of its tyres sideways
// holds on ground of that friction, less a tenth for what pushes at it. Places up to
// kSteepestForLegs_deg and kSteepestForWheels_deg are legal still.
double HoldingSlope_deg(AgentCategory category, double friction);

// What is wrong with a place, without the cost of saying it: searches look at many.
struct SpawnSite {
  SpawnFlaw flaw = SpawnFlaw::kNone;
  double figure = 0.0;      // depth [m] or slope [deg] that was found
  std::uint32_t asset = 0;  // kSolid: which
  double slope_deg = 0.0;   // kNone, of legs and wheels: the steepest below the body
};

// Depth, under that weather, and slope are taken at the centre and at eight points of the body's
// rim. changes: assets that do not stand are no matter; null: all stand.
SpawnSite ExamineSpawn(const Scene& scene, const Atmosphere& atmosphere, AgentCategory category,
                       double body_radius_m, WorldPoint position,
                       const SceneChanges* changes = nullptr);

// "the water is 1.2 m deep, and legs ford at most 0.2 m".
std::string Describe(const Scene& scene, AgentCategory category, double body_radius_m,
                     const SpawnSite& site);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_AGENTS_SPAWN_SITE_H_
