#include "latticeworld/simulation/agents/minds/look_around.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/bodies/footing.h"
#include "latticeworld/simulation/agents/ways/steering.h"

namespace latticeworld {
namespace {

constexpr double kClearance_m = 0.12;  // kept from solid things beside the body's own radius
constexpr double kEdge_m = 0.3;        // kept from the edge of the world
constexpr double kThin_m = 0.02;       // of the ray that must not go through a wall
constexpr double kDeckEdge_m = 0.3;    // kept by its middle from the edge of a bridge

double StrideOf(const Species& species) { return species.plan == BodyPlan::kSwimmer ? 2.0 : 0.5; }

// What does not depend on solid things, off bridges.
bool IsGroundItselfGood(const Surroundings& world, const Agent& agent, WorldPoint place) {
  const Species& species = *agent.species;
  const double half_m = world.scene->geometry().half_size_m() - species.radius_m - kEdge_m;
  if (!(std::abs(place.x_m) <= half_m && std::abs(place.y_m) <= half_m)) return false;
  if (species.plan == BodyPlan::kFlyer) return true;
  const double depth_m = world.WaterDepthAt(place);
  if (species.plan == BodyPlan::kSwimmer) return depth_m >= species.wade_depth_m;
  if (depth_m > species.wade_depth_m) return false;
  // No steeper than it can climb, nor than its feet hold on wet or snowy ground.
  const SurfaceProperties& surface = world.surfaces->Of(world.scene->terrain->SurfaceAt(place));
  const double climbable_rad =
      ClimbableSlope(surface, species.grip, species.plan == BodyPlan::kVehicle);
  return world.scene->terrain->ground.SlopeAt(place) <=
         std::min(species.max_slope_rad, climbable_rad);
}

bool IsGroundGood(const Surroundings& world, const Agent& agent, WorldPoint place) {
  if (IsGroundItselfGood(world, agent, place)) return true;
  return !KeepsAfloat(agent.species->plan) && world.scene->geometry().Contains(place) &&
         IsCarried(*PropsIn(*world.scene, *world.changes), place, kDeckEdge_m,
                   agent.species->mass_kg);
}

bool IsGroundGoodAlong(const Surroundings& world, const Agent& agent, WorldPoint from,
                       WorldPoint to) {
  return HoldsAlong(from, to, StrideOf(*agent.species),
                    [&](WorldPoint place) { return IsGroundGood(world, agent, place); });
}

double MarginOf(const Agent& agent) { return agent.species->radius_m + kClearance_m; }

// is_clear(from, to, margin): of solid things.
template <typename IsClear>
bool StandsAt(const Surroundings& world, const Agent& agent, WorldPoint place,
              const IsClear& is_clear) {
  if (!IsGroundGood(world, agent, place)) return false;
  return agent.species->plan == BodyPlan::kFlyer || is_clear(place, place, MarginOf(agent));
}

template <typename IsClear>
bool GoesTo(const Surroundings& world, const Agent& agent, WorldPoint from, WorldPoint to,
            bool begins_well, const IsClear& is_clear) {
  // From where it should not be (pushed, or begun too close to something) any way out will do that
  // does not lead through a wall.
  if (!begins_well) {
    return StandsAt(world, agent, to, is_clear) &&
           (agent.species->plan == BodyPlan::kFlyer || is_clear(from, to, kThin_m));
  }
  if (!IsGroundGoodAlong(world, agent, from, to)) return false;
  return agent.species->plan == BodyPlan::kFlyer || is_clear(from, to, MarginOf(agent));
}

}  // namespace

bool CanStand(const Surroundings& world, const Agent& agent, WorldPoint place) {
  return StandsAt(world, agent, place, [&](WorldPoint from, WorldPoint to, double margin_m) {
    return IsWayClear(*world.scene, *world.changes, from, to, margin_m, agent.species->height_m);
  });
}

bool CanGo(const Surroundings& world, const Agent& agent, WorldPoint from, WorldPoint to) {
  const auto is_clear = [&](WorldPoint a, WorldPoint b, double margin_m) {
    return IsWayClear(*world.scene, *world.changes, a, b, margin_m, agent.species->height_m);
  };
  return GoesTo(world, agent, from, to, StandsAt(world, agent, from, is_clear), is_clear);
}

LookAround::LookAround(const Surroundings& world, const Agent& agent, double reach_m)
    : world_(world),
      agent_(agent),
      solids_(*world.scene, *world.changes, agent.place(),
              agent.species->plan == BodyPlan::kFlyer ? 0.0 : reach_m + MarginOf(agent),
              agent.species->height_m),
      begins_well_(StandsAt(world, agent, agent.place(),
                            [this](WorldPoint from, WorldPoint to, double margin_m) {
                              return solids_.IsWayClear(from, to, margin_m);
                            })) {}

bool LookAround::CanGo(double heading_rad, double distance_m) const {
  const WorldPoint here = agent_.place();
  return GoesTo(world_, agent_, here, Ahead(here, heading_rad, distance_m), begins_well_,
                [this](WorldPoint from, WorldPoint to, double margin_m) {
                  return solids_.IsWayClear(from, to, margin_m);
                });
}

std::optional<double> LookAround::ClearHeading(double wanted_rad, double distance_m,
                                               int* turn_side) const {
  constexpr double kTurns_rad[] = {0.0, 0.4, 0.8, 1.2, 1.6, 2.1, 2.7};
  return FirstClearHeading(wanted_rad, kTurns_rad, turn_side,
                           [&](double heading_rad) { return CanGo(heading_rad, distance_m); });
}

}  // namespace latticeworld
